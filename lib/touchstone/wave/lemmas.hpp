// SPDX-License-Identifier: MIT
/// \file
/// What is proven about the operator (wave.hpp), a lemma a function: the docstring is the statement and its proof, the body what engines
/// use of it. Each is checked, and refuted where it is perturbed, by proofs/operator (`touchstone paper --own`). B_m = T^(m+1) 1 or T^m
/// B_0, B_0 the share of one wave in contact or above a pressure; h_m = G^m B_m/x; G > 1 unless said otherwise.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/scalar.hpp"
#include "touchstone/wave/wave.hpp"

#include <cmath>
#include <vector>

namespace touchstone::wave {

// ---- the whole operator

/// **Lemma (equilibrium):** T y = x/G in both regimes: the mean pressure is the load.
/// *Proof.* (1/pi) int (x + cos theta)/G dtheta = x/G. For x < 1 by c = 1 - 2 x sin^2(psi): dtheta = 2 x^(1/2) cos(psi)/(1 - x sin^2
/// psi)^(1/2) dpsi and y = (2/G) (x (1 - x sin^2 psi))^(1/2) cos(psi), so y dtheta/pi = (4x/(pi G)) cos^2(psi) dpsi, and int_0^(pi/2) cos^2
/// = pi/4.
template <Field T>
T equilibrium(const T& x, const T& G) { return x / G; }

/// **Lemma (positivity):** phi <= chi implies T phi <= T chi; and T 1 <= min(1, x^(1/2)). So where |B_{m-1} - V_{m-1}| <= e, |B_m - V_m| <=
/// T e + |T V_{m-1} - V_m|: errors are averaged and added, never amplified.
/// *Proof.* T is a mean over theta, of nothing where contact is lost: its kernel is positive, of mass T 1 = (2/pi) arcsin x^(1/2) for x <
/// 1, 1 beyond; and arcsin is convex on [0, 1], so below its chord.
template <Field T>
T positivity(const T& x)
{
    using std::sqrt;
    return sqrt(x);
}

/// **Lemma (monotone):** y increases with x at constant theta, and across x = 1: so B_m increases with x if B_0 does.
/// *Proof.* dP/dx = 1, resp. d(P^2)/dx = 2(1 + c) >= 0; both are 1 + c at x = 1.
///
/// d(P^2)/dx of (2.4)
template <Field T>
T monotone(const T& c) { return 2 * (1 + c); }

/// **Lemma (after_the_fact):** For any V_m and D_m >= |T V_{m-1} - V_m|, D_0 >= |B_0 - V_0|: |B_n - T V_{n-1}| <= sum over m < n of T^(n-m)
/// D_m. *Proof.* Induction from positivity: |B_m - V_m| <= |T B_{m-1} - T V_{m-1}| + D_m <= T |B_{m-1} - V_{m-1}| + D_m.
///
/// The error of one level more.
template <Field T>
T after_the_fact(const T& averaged_error, const T& defect) { return averaged_error + defect; }

/// **Lemma (share_of):** An interval of c of length w has at most the share (w/2)^(1/2) of theta in [0, pi]. An interval of y of length h
/// is one of c of length at most G h. So (T 1_J)(x) <= (G |J|/2)^(1/2) for every x and every interval J.
/// *Proof.* (1/pi) int dc/(1 - c^2)^(1/2) over an interval of length w is largest at an end of [-1, 1], where it is (2/pi) arcsin
/// (w/2)^(1/2) <= (w/2)^(1/2). dc = G dy for x >= 1, (G y/R) G dy for x < 1, R^2 = (1-x)^2 + G^2 y^2.
template <Field T>
T share_of(const T& width_of_c)
{
    using std::sqrt;
    return sqrt(width_of_c / 2);
}

/// **Lemma (share_of_twice):** (T^2 1_J)(x) <= l (1 + 2 G^(1/2) + ((2G)^(1/2)/pi) log+(1/(2 l))), l = G |J|.
/// *Proof.* T 1_J(y) <= (l/2)^(1/2), and <= l/(pi d^(1/2)) unless J, seen from y, comes within d (in c) of an end of the wave; those y are
/// at most four intervals of length l + d, of share at most (G(l + d)/2)^(1/2) each. Integrate over the level t of T 1_J from t0 = l
/// (8G)^(1/2)/pi (d = 1/8G) on: int 4 (G/2)^(1/2) (l^(1/2) + l/(pi t)) dt up to (l/2)^(1/2) is l (2 G^(1/2) + ((2G)^(1/2)/pi) log(pi^2/(16
/// G l))), and with t0 that is at most the above, because G^(1/2) (8^(1/2)/pi)(1 + (1/2) log(pi^2/(8 G))) <= 1, with equality at G =
/// pi^2/8.
inline double share_of_twice(double G, double l)
{
    return l * (1 + 2 * std::sqrt(G) + std::sqrt(2 * G) / pi<double>() * std::fmax(0.0, std::log(1 / (2 * l))));
}

/// **Lemma (after_steps):** T^k 1 <= C_k x^(a_k), a_1 = 1/2, C_1 = 1, a_{k+1} = (1 + a_k)/2, C_{k+1} = C_k G^(-a_k).
/// *Proof.* Hoelder's inequality with weights y and 1: T y^a <= (T y)^a (T 1)^(1-a) <= (x/G)^a x^((1-a)/2).
struct Power {
    double factor = 1, exponent = 0.5; ///< C_k, a_k
};
inline Power after_steps(const Power& k, double G)
{
    return {k.factor * std::pow(G, -k.exponent), (1 + k.exponent) / 2};
} ///< C_{k+1}, a_{k+1}; rounded

/// **Lemma (singular_set):** The singular points of B_m are the images, under s -> G s + 1 and s -> G s - 1 (if >= 1) or G^2 s^2/4 (else),
/// of 1, which every level adds afresh. G s - 1 >= 1 exactly where G^2 s^2/4 >= 1: a point has one of the two images.
/// *Proof.* Where no singular point meets an end of the wave, its path can be moved off the real axis; the wave itself changes at x = 1
/// alone.
///
/// Whether the second image of s is G s - 1.
template <OrderedScalar T>
Truth singular_set(const T& s, const T& G) { return less(T(2) / G, s); }

/// **Lemma (continuity):** 0 <= B_m(x + h) - B_m(x) <= (h/G^m)^(1/2) for areas, x >= 0, h >= 0.
/// *Proof.* arcsin (x+h)^(1/2) - arcsin x^(1/2), the integral of 1/(2 (t(1-t))^(1/2)) over a window of [0, 1], is largest at an end of it:
/// at most arcsin h^(1/2) <= (pi/2) h^(1/2). At constant theta y <= y' (monotone), of mean difference h/G (equilibrium), and the square
/// root is concave (Jensen): h/G^m goes to h/G^(m+1).
template <Field T>
T continuity(const T& h, const T& G_to_m)
{
    using std::sqrt;
    return sqrt(h / G_to_m);
}

/// **Lemma (shift):** For |V| <= 1, h = |x - x'| and both on one side of 1: |T V(x) - T V(x')| <= (32 h)^(1/2).
/// *Proof.* x >= 1: one arcsine law, shifted by h in c, whose density decreases, then increases: the two differ by at most 4 times the mass
/// within h of an end, (h/2)^(1/2) by share_of. x < 1: the same for R = x + c, and once more for P^2 = R^2 - (1-x)^2, whose window of
/// (1-x)^2 - (1-x')^2 is one of at most h in c.
constexpr double shift = 32;

// ---- partial contact: G > 2, load <= 1

/// **Lemma 1 (half_plane):** Let x = e^-s. For Re s > 0 and u in [0, 1), s_y = -log y is analytic in s and Re s_y > log(G/2) + Re(s)/2.
/// *Proof.* s_y = log(G/2) + s/2 - log(1 - u^2)/2 - log(1 - u^2 e^-s)/2; the last logarithm is analytic since |u^2 e^-s| < 1, and
/// (1 - u^2)|1 - u^2 e^-s| <= (1 - u^2)(1 + u^2) <= 1.
///
/// The bound.
template <Field T>
T half_plane(const T& log_half_G, const T& re_s) { return log_half_G + re_s / 2; }

/// **Lemma (force_weighted):** In units of force T is an average whose noise does not depend on x: h_{m+1}(x) = (4/pi) int_0^1 h_m(y) (1 -
/// u^2)^(1/2) du, u = sin psi. *Proof.* B_m(y) = y h_m(y)/G^m and y/(1 - x u^2)^(1/2) = (2/G)(x (1 - u^2))^(1/2); (4/pi) int_0^1 (1 -
/// u^2)^(1/2) du = 1.
///
/// The weight of du.
template <Scalar T>
T force_weighted(const T& u)
{
    using std::sqrt;
    return 4 / pi<T>() * sqrt(1 - u * u);
}

/// **Lemma 2 (size):** As a function of s, h_m is analytic in Re s > 0 and |h_m| <= c_m |x|^(-a_m) there, a_m = 2^(-m-1), c_0 = 1,
/// c_{m+1} = c_m (G/2)^(a_m) (2/pi^(1/2)) Gamma(3/2 - a_m)/Gamma(2 - a_m).
/// *Proof.* |arcsin z| <= arcsin |z| <= (pi/2)|z| for |z| <= 1 (positive Taylor coefficients, convexity), so |h_0| <= |x|^(-1/2). By Lemma
/// 1 (force_weighted) extends to Re s > 0, and
/// |y|^-a <= ((2/G)|x|^(1/2)(1 - u^2))^-a because |1 - x u^2| >= 1 - u^2; int_0^1 (1-u^2)^(1/2-a) du = (pi^(1/2)/2) Gamma(3/2-a)/Gamma(2-a).
///
/// \returns c_0 ... c_levels, enclosed. \pre G >= 2
std::vector<Ball> size(const Ball& G, long levels);

// ---- full contact: the disc on which T V~ is analytic, V~ continued at each end of the wave by the polynomial of one panel (recursion's
// after-the-fact proof)

/// **Lemma (disc_full):** x_c > 1, |x - x_c| <= r <= reach g, g = |1 -+ c| at the edge where the continued polynomial takes over: |1 -+ c|
/// keeps a fifth of itself on the middle part, where therefore |T V~| <= middle sup|V|, and grows at most to grown g at the end.
struct DiscFull {
    double reach = 0.79, middle = 5, grown = 1.8; ///< each as in the lemma
};
inline constexpr DiscFull disc_full; ///< the constants proved

/// **Lemma (disc_partial):** x_c < 1, |x - x_c| <= r <= reach (1 - x_c): at constant P, |R| >= radius_kept R_c with Re R > 0, |R - R_c| <=
/// radius_moves r, so c moves by at most cosine_moves r, which is to be within reach_at_end g; 1 + c keeps one_plus_c_kept of itself, |1 -
/// c| a fifth, and |T V~| <= middle sup|V| on the middle part. *Proof.* |R^2 - R_c^2| = |x - x_c||2(1 - x_c) - (x - x_c)| <= reach (2 +
/// reach)(1 - x_c)^2 <= 0.5376 R_c^2, and Re (1 + t)^(1/2) >= (1 - q)^(1/2) on |t| <= q; R_c >= 1 - x_c; 1 + c = R + 1 - x >= 2 (1 - x).
struct DiscPartial {
    double reach = 0.24, radius_kept = 0.66, radius_moves = 1.36, cosine_moves = 2.36, one_plus_c_kept = 0.7,
           middle = 4.1; ///< each as in the lemma
};
inline constexpr DiscPartial disc_partial; ///< the constants proved

/// **Lemma (disc_two_waves):** Let the ends of the first of two waves move by less than share of their distance from every singular point
/// that matters, x by less than share of its own and of 1 - x: then |D_1| <= most D_1(x_c), the density after two waves.
/// *Proof.* Two distances keep 1 - 2 share and 1 - share of themselves, dy grows by 1 + 2 share; |R^2 - R_c^2| <= share (2 + share) R_c^2,
/// so |R| and what is added to it keep (1 - share (2 + share))^(1/2); the factors of (2.19) of either wave follow.
struct DiscTwoWaves {
    double share = 0.3, most = 75; ///< each as in the lemma
};
inline constexpr DiscTwoWaves disc_two_waves; ///< the constants proved

} // namespace touchstone::wave
