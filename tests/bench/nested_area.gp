\\ The peer of bench_contact_area: the single nested integral A_2 at 50 digits, load 1/10, G = sqrt 10.
\\     gp -q nested_area.gp        prints the value and the milliseconds it took
default(realprecision, 57);
G = sqrt(10);
T(f, x) = 2/Pi * sqrt(x) * intnum(t = 0, Pi/2, my(s = sin(t), c = cos(t), d = sqrt(1 - x*s^2)); f(2/G * sqrt(x) * c * d) * c/d);
B0(x) = 2/Pi * asin(sqrt(x));
start = getwalltime();
area = T(y -> T(B0, y), 1/10);
printf("%.50g\n%d\n", area, getwalltime() - start);
