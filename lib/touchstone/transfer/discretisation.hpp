// SPDX-License-Identifier: MIT
/// \file
/// The transfer operator of one G, made finite, with everything it leaves out bounded.
///
/// F_m = x^(1/2) h_m (chain.hpp) is kept by its values at the N Chebyshev points of one or more blocks of
/// x_min <= x <= 2/G. One step is the N x N matrix B, B_ij = sum_q W_iq l_j(tau_iq): a quadrature rule (rule.hpp) on
/// row x_i, its values taken from the interpolant. It is applied as M C: C takes nodal values to Chebyshev coefficients, M_ik = sum_q W_iq T_k(tau_iq). Two discretisations that have no grid, rule, form or x_min in common:
///
/// | scheme         | form of the step       | variable     | blocks               | rule                   |
/// |----------------|------------------------|--------------|----------------------|------------------------|
/// | force_weighted | average (C3) of h      | log(-log x)  | a few, equally long  | trapezoid, v = c sinh r |
/// | area           | integral (C2) of B     | -log x       | [s, 4s], [4s, 16s],..| Gauss-Legendre panels   |
///
/// **Error of one step.** Let |F_m| <= c_m (Lemma 2, for Re s > 0). Then |(B F_m)_i - F_{m+1}(x_i)| <= eta, the sum of
///  1. the rule's discretisation and truncation, bounds of rule.hpp times c_m;
///  2. interpolation, R_i 4 c_m rho^-(p-1)/(rho - 1), R_i = sum_q W_iq: the p Chebyshev points of a block whose ellipse
///     E_rho lies in Re s > 0 (coefficients <= 2 c_m rho^-k, each k >= p aliased once);
///  3. the point where the interpolant is evaluated, off by dtau: sum_q W_iq dtau c_m/((rho + 1/rho)/2 - 1), Cauchy's bound of F';
///  4. the weights, off by dW: (number of nodes) dW c_m;
///  5. rounding. A moment of order k only ever meets a coefficient of the interpolant of F, at most 2 c_m (1 + 2/(rho^2 - 1)) rho^-k, aliases and
///     all: so it is summed in units u rho^k, words below that let go. An error of 4 units in each step of the recurrence contributes at
///     most 4 (k - j + 1), so it is off by (nodes) 4 u rho^k p^2. And coefficients as computed are off: budget().
/// All five are computed for every row and added up in balls.
///
/// **Errors over n steps.** With B = M C, M as computed: e_{m+1} = B e_m + a_{m+1} with |a_m| <= alpha, one vector for all m (c_m increases to its
/// limit), so e_n is a sum of n + 1 terms B^j a. Let W(k) bound |sum of k such terms|, in every component:
/// W(1) = alpha and W(k + p) = |B^p| W(k) + W(p), for p the largest power of two up to k that |B^p| is kept for.
/// |B| alone has a spectral radius of 1.05 to 2 and more, for large G; high powers come down to |rank one|. No stability theory is used:
/// the |B^p| and the W(k) are computed, in `double`, each rounded up by more than its own rounding errors.
///
/// **Cost.** Rows: N x nodes x p products of fixed-point numbers, most of them short: a term of weight W and order k has the words of W rho^-k; then N^2 products for each level and
/// p x nodes for each load. N and the nodes grow like the number of digits. B itself is only needed for the errors, in binary64.
#pragma once

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/coefficients.hpp"
#include "touchstone/transfer/rule.hpp"

#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <vector>

namespace touchstone::transfer {

enum class Scheme { force_weighted, area };

/// How the error bound of one value is made up; each part bounds |error of F|.
struct Budget {
    Ball rule, truncation, interpolation, abscissae, weights, entries;
    Ball total() const { return rule + truncation + interpolation + abscissae + weights + entries; }
};

/// The errors of a level are no longer below the values; more digits help.
class ErrorsHaveOutgrown : public BeyondReach {
    using BeyondReach::BeyondReach;
};

class Discretisation {
public:
    /// \param G_at encloses G > 2 at the thread's precision, any precision
    /// \param accuracy F_m is wanted to about e^-accuracy, relative to c_m
    /// \param grid_accuracy the share of interpolation in it: fewer nodes, and a proven error that is theirs alone
    /// \param deepest rows reach the load e^-deepest, however inaccurate F is there: its next ratios are on the grid
    Discretisation(Scheme, const std::function<Ball()>& G_at, double accuracy, double grid_accuracy, double deepest = 0);
    Discretisation(Scheme scheme, const std::function<Ball()>& G_at, double accuracy) : Discretisation(scheme, G_at, accuracy, accuracy) {}

    static constexpr std::size_t most_nodes = 4000;
    /// The nodes that a grid of this accuracy would have; above most_nodes it is refused.
    static std::size_t size_for(Scheme, const Ball& G, double accuracy, double deepest);

    /// Whether the ellipse E_rho about mid +- half of a scheme's variable is proven inside Re s > 0.
    static bool ellipse_is_inside(Scheme, double mid, double half, double rho);

    /// The precision in bits that G and loads should be given with.
    slong bits() const { return bits_; }
    static slong bits_for(double accuracy, double deepest);

    /// F_n(x) = x^(1/2) h_n(x) for 0 < x <= 1, n >= 0. Thread-safe; levels are computed once.
    /// \throws BeyondReach where x is below the reach of the grid
    Ball force_share(long n, const Ball& x);

    struct Point {
        Ball x, weight;
    };
    /// sum_i w_i F_n(x_i) as one row, for all n.
    struct Functional {
        Ball first;                     ///< n = 0
        std::vector<mp_limb_t> moments; ///< by coefficients, for n >= 1
        std::vector<double> modulus;    ///< at least the absolute values of the row by nodal values
        Ball budget;                    ///< the row's error, divided by c_m
    };
    Functional functional(const std::vector<Point>&);
    Ball apply(const Functional&, long n);

    /// The certificate: parameters, error budget of a row, and the proven error level by level up to n.
    std::string certificate(long n);

    /// The largest parts of the rows' budgets, divided by c_m, and what they are made of.
    const Budget& worst() const { return worst_; }
    long points_of_block() const { return blocks_.front().points; }
    double rho() const { return blocks_.front().rho; }

    std::size_t size() const { return nodes_.size(); }
    /// Bytes held.
    std::size_t memory() const;

private:
    struct Block {
        double mid, half; ///< of the variable
        double rho;       ///< ellipse proven inside Re s > 0
        long points;
        std::size_t first; ///< index of its first node
    };
    struct Row {
        std::vector<mp_limb_t> moments; ///< sum_q W T_k(tau), by block
        Ball total;                     ///< sum_q W
        Ball tau_error, weight_error; ///< sum_q W dtau_q, and the largest of dW_q
        long terms = 0;
    };
    struct Level {
        std::vector<mp_limb_t> coefficients; ///< of the polynomials through the values of F_m/scale at the nodes, by block
        std::vector<double> errors;          ///< W(m + 1): bounds of the errors of those values, in units 2^-error_unit_
    };

    static FixedFormat format_for(double accuracy);
    static double accuracy_of_entries(double accuracy, double deepest);
    static std::vector<Block> grid(Scheme, const Ball& G, double accuracy, double grid_accuracy, double V, double deepest);
    static double rule_end(Scheme, const Ball& G, double accuracy);
    struct Step {
        std::string load;
        Functional row;
    };
    const Functional& step_to(const Ball& x);
    Ball value(const Functional&, long n) const;
    Row row(const Ball& x, const Ball& s, const Rule&) const;
    /// The row's error bound, divided by c_m, apart from what the level's values carry.
    Budget budget(const Row&, const Ball& x, const Rule&) const;
    Ball coefficient_bound() const;
    double nodal(const mp_limb_t* moments, double* near) const;
    void extend_to(long n);
    void square_power();
    std::vector<double> errors_of(std::size_t level);
    double to_error_units(const Ball&) const;

    Scheme scheme_;
    double accuracy_;
    FixedFormat format_;
    slong bits_;
    Ball G_, log_half_G_;
    Rule rule_;
    std::vector<Block> blocks_;
    struct Node { Ball x, s; };
    std::vector<Node> nodes_;
    std::vector<mp_limb_t> matrix_;       ///< the rows' moments, N x N fixed-point numbers
    Coefficients to_coefficients_;        ///< of every block
    std::vector<std::vector<double>> powers_; ///< |B^(2^r)|, rounded up; r > 0 made when needed
    std::vector<double> near_power_;      ///< the last power itself, to a relative near_error_ of majorant_
    std::vector<double> majorant_;        ///< |B|^(2^r)
    double near_error_ = 0;
    std::vector<double> step_error_;      ///< alpha, in error units
    Budget worst_;                        ///< componentwise largest over the rows
    std::vector<Ball> c_;
    Ball scale_;                          ///< power of two >= every c_m in use
    long error_unit_;
    std::vector<Level> levels_;
    std::list<Step> steps_; ///< most recently used first
    std::mutex mutex_;
};

} // namespace touchstone::transfer
