// SPDX-License-Identifier: MIT
/// \file
/// Distribution of the contact pressure at scale n by the forward recursion (6.1), certified, for one G > 2 and load <= 1.
///
/// Let x_k = p_{k-1}/p*_k, x_0 = load (chain.hpp); its largest value is e_k, e_0 = load, e_{k+1} = (2/G) sqrt(e_k), (5.6).
/// Everything is a function of the distance from that edge, d = log(e_k/x_k) >= 0. If a region has delta at scale k and d
/// at scale k + 1 then 0 <= delta <= 2d; put delta = 2d s, D = 2d (1-s), s = sin^2 theta, x = e_k e^-delta and
///
///     R^2 = (1-x)^2 + 4 e_k e^(-2d),   P = 1+x+R,   M = 1-x+R,   E(z) = (1-e^-z)/z.
///
/// | law        | unknown of scale k                                         | from (2.17), (2.19)                            |
/// |------------|------------------------------------------------------------|------------------------------------------------|
/// | density    | share of force per unit of d: d^(k/2-1) e^(-3d) C_k v_k(d) | v_{k+1} = <sin^(k-1)| (P/(M E(D)))^(1/2)/R u_k>  |
/// | exceedance | share of length above, E_k = d^(k/2) C_k v_k(d)            | v_{k+1} = <sin^(k+1)| (P M/E(D))^(1/2)/R u_k>    |
///
/// with u_k = e^(-b d) v_k, b = 3/2 or 1/2, <sin^m| f> = int_0^(pi/2) sin^m f dtheta / int_0^(pi/2) sin^m dtheta, u_k taken at
/// 2d s. The first step is closed: v_1 = (P/(M E))^(1/2)/R, or arcsin(z)/(2d)^(1/2), z^2 = 4 d x E/P, at x = load, D = 2d.
///  - density: q_n = load f_{n+1}/p^2, f the law's unknown. Exceedance: f_n, as a share of length, against Q of (2.17).
///  - exceedance: Q_n = E_{n+1}; q_n = (1/p) dE_{n+1}/dd, the derivative of (and under) the integral, or as below where p is small.
///
/// **Analyticity.** delta = 2d s stays on the ray of d. So each direction arg d is on its own: if u_k is analytic with known
/// bounds on a star-shaped set and P, M, R^2, E meet no branch cut, u_{k+1} is, and is bounded by the average of the bounds.
/// The plane of d is cut into boxes (shell, direction); each level's boxes are proven and bounded over discs (disc.hpp). The radius
/// of analyticity at the edge halves with each scale, the sector does not. A last box per direction is unbounded; there
/// |1/E(D)| <= |D| + 1/cos and e^(-b d) wins.
///
/// **The boundary is enough.** Rules and polynomials below want an integrand, or u_k, analytic and bounded in an ellipse; only its boundary
/// is looked at. Let w be an argument of a root or an arcsine (R^2, P, M, E, 1 - z^2), or delta for u_k, in the order in which they are
/// computed: each is analytic inside once those before it are. It maps the boundary to a closed curve in a set S: the plane without (-inf,
/// 0], the disc about 1, or the star of the boxes. Every point outside S is joined to infinity by a ray outside S, so the curve does not
/// wind around it, and by the argument principle w does not take that value inside. So every root is analytic inside, and so is the
/// integrand, which the maximum principle then bounds by what it is on the boundary. That the integrand is finite there would not do:
/// |arcsin z| <= (pi/2)|z| holds all round a zero of E, where z = (4 d x c E/P)^(1/2) branches.
///
/// **Level.** u_k is kept as interpolating polynomials on panels, in d next to the edge, beyond in d (density) or log d
/// (exceedance): |error| <= 4 U rho^-(N-1)/(rho-1), U the bound on an ellipse of boxes.
/// **Row.** v_{k+1}(d) by Gauss-Legendre on pieces of t = tan(theta/2), which leaves no end-point singularity;
/// |error| <= l (16/3) M r^(-2n)/(1-1/r) as in rule.hpp, M bounded on the ellipse over discs. Its exact integrand knows no
/// panels, so pieces need not respect them. Pieces whose bound is negligible are left out.
/// **Far end.** delta > delta_max is left out: E_k <= 1 leaves at most e_k^(1/2) e^(-delta_max/2) of E_{k+1}; for the density
/// f_k <= T_k e^(-5 delta/2) for delta >= 4, k >= 2 (by induction from total force 1, far_end.hpp).
/// **Errors over levels.** A node's error is its row's, plus sum_j |B_j| (error of node j), B_j the row applied to the j-th
/// Lagrange polynomial: computed in `double`, with its rounding covered. The step is an average, so these hardly grow.
///
/// **Small p.** dE_{n+1}/dd cancels 2d nats. With s = dE_n/ddelta, D = 2d - delta, p/p*_n = 2 e_n^(1/2) e^-d, so 4x - (p/p*_n)^2 = 4x (1 -
/// e^-D) in (2.19), a cut c and a remainder r >= 0, the exceedance law gives for n >= 2, 2d > c + 1, by parts (E_n(0) = 0),
///
///     q_n = e^-d/(pi G^n) int_0^2d s H ddelta,   int_0^2d s H = E_n(c) H(c) - int_0^c E_n H' + r,
///     H = e^(delta/2) h,   h = (P/M)^(1/2)/(R (1-e^-D)^(1/2)).
///
///  - r: s = load f/(G^n x), f the density of force, f <= T_n e^(2-3 delta) w(delta) for delta >= 4, w = 1, or (delta+1.2)/5.2 at n = 2
///    (far_end.hpp); h <= ((1-x)^3 (1-e^-D))^(-1/2), for R, M/2 >= 1-x and P/M falls with R; int_c^2d e^(-3 delta/2) w (1-e^-D)^(-1/2)
///    <= 3.5 w(c+1) e^(-3c/2): D > 1 makes 1.26 times the integral without the root, D < 1 at most 2.52 w e^(-3c/2). So
///    r <= load/(G^n e_n) (1-e_n e^-c)^(-3/2) 3.5 T_n w(c+1) e^(2-3c/2), whatever p is.
///  - Errors of E_n: times |H'| <= 1.26 (1-x)^(-3/2) (0.8 + 1.75 x/(1-x)) e^(delta/2), and |H(c)|. They grow by e^(c/2), all that cancels;
///    c is where r comes to the same. Here E_n itself is interpolated (in log d; v_n next to the edge), from rows of level n - 1:
///    u_n would lose e^(c/2) once more.
///  - int_0^c by acb_calc_integrate in delta^(1/2) or log delta, the roots of H' off their cuts.
///
/// At n = 1 r does not fall with c (load = 1: q_1 ~ p log p); the catalogue uses scale_one.hpp.
#pragma once

#include "touchstone/transfer/contact.hpp"

#include <functional>
#include <memory>
#include <string>

namespace touchstone::transfer {

enum class Law { density, exceedance };

/// The levels of one (G, load) by one law. Thread-safe; levels are computed once.
class Forward {
public:
    /// The distributions of p_0 to p_largest_n.
    static constexpr long largest_n = 20;
    /// \param G_at, load_at enclose G > 2, 0 < load <= 1 at the thread's precision, any precision
    /// \param accuracy relative accuracy of values is to be about e^-accuracy
    Forward(Law, const std::function<Ball()>& G_at, const std::function<Ball()>& load_at, double accuracy);
    ~Forward();

    /// The precision in bits that d should be known to.
    slong bits() const;
    /// q_n(p) p*_0 for 0 < p < p_n^max, d = log(p_n^max/p), 1 <= n <= largest_n. \throws BeyondReach
    Ball density(long n, const Ball& p, const Ball& d);
    /// Share of lambda_0 with p_n > p, same domain.
    Ball exceedance(long n, const Ball& d);
    /// int p q_n dp over the whole support, 1 <= n <= largest_n, from the polynomials and proven errors of level n + 1 itself: encloses the
    /// load where the levels are right. Nothing relies on it: it is there to find out whether they are.
    Ball force(long n);
    /// int q_n dp, likewise: encloses A_n/lambda_0. Density law only.
    Ball mass(long n);
    /// The error budget level by level, and of the row at p.
    std::string certificate(long n, const Ball& p, const Ball& d);
    std::size_t memory() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// (6.1)  q_n(p) p*_0, and the share of lambda_0 with p_n > p, for 0 < p < p_n^max, 1 <= n <= largest_n, to about the accuracy wanted.
/// The levels of a (G, load) are kept for later calls that need no more accuracy, nor much less (most recently used first, at most about
/// 300 MB).
/// \throws BeyondReach unless G > 2, 0 < load <= 1 and p < p_n^max are proven, or where the digits would cost too much
Ball density(Law, long n, const std::function<Ball()>& p, const Arguments&, Accuracy);
Ball exceedance(Law, long n, const std::function<Ball()>& p, const Arguments&, Accuracy);
/// How many levels the calls so far have made, all others having found theirs kept.
long levels_made();
/// The most digits that cost little enough for both laws to give them: fewer where p is small.
long most_digits_of_distribution(long n, const std::function<Ball()>& p, const Arguments&, bool for_density);
/// int p q_n dp by the levels of this law, and int q_n dp by those of the density: see Forward.
Ball force(Law, long n, const Arguments&, Accuracy);
Ball mass(long n, const Arguments&, Accuracy);
std::string distribution_certificate(Law, long n, const std::function<Ball()>& p, const Arguments&, Accuracy);

} // namespace touchstone::transfer
