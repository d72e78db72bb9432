\\ q_2(p) and Q_2(p) by nested integrals of (6.1), (2.17), (2.19), no code shared with the project.
\\ load = 1/10, G = sqrt 10, p = 5; run with: gp -q tests/bench/nested_density.gp
default(realprecision, 38);
load = 1/10; G = sqrt(10); p = 5;
R(x, P) = sqrt((1 - x)^2 + P^2);
A(x, P) = P/(Pi*R(x, P))*sqrt((1 + x + R(x, P))/(1 - x + R(x, P)));  \\ (2.19) is A/sqrt(4x - P^2)
Q(x, P) = 2/Pi*asin(sqrt((4*x - P^2)/(2*(1 + x + R(x, P)))));        \\ (2.17)
hi = 2*sqrt(load); top = 2*sqrt(hi*G);
\\ q_1, both ends of the range of p_0 by sin^2
q1(y) = {my(lo = y^2/(4*G)); intnum(t = 0, Pi/2, my(z = lo + (hi - lo)*sin(t)^2); A(z/G, y/G)*A(load, z)/sqrt(hi + z))/sqrt(G)};
lo = p^2/(4*G^2); w = top - lo;
print(intnum(v = 0, 1, my(y = lo + w*v^2); q1(y)*A(y/G^2, p/G^2))*sqrt(w)/G);
print(intnum(v = 0, 1, my(y = lo + w*v^2); 2*w*v*q1(y)*Q(y/G^2, p/G^2)));
