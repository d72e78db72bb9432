// SPDX-License-Identifier: MIT
/// \file
/// The transfer operator of one G, made finite, with everything it leaves out bounded.
///
/// F_m = x^(1/2) h_m (chain.hpp) is kept by its values at the N Chebyshev points of one or more blocks of
/// x_min <= x <= 2/G. One step is the N x N matrix B, B_ij = sum_q W_iq l_j(tau_iq): a quadrature rule (rule.hpp) on
/// row x_i, its values taken from the interpolant. It is applied as M C: C takes nodal values to Chebyshev coefficients, M_ik = sum_q W_iq
/// T_k(tau_iq). Two discretisations that have no grid, rule, form or x_min in common:
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
///  5. rounding. A moment of order k only ever meets a coefficient of the interpolant of F, at most 2 c_m (1 + 2/(rho^2 - 1)) rho^-k,
///     aliases and all: so it is summed in units u rho^k (moments.hpp), and is off by (nodes) 4 u rho^k p^2. And coefficients as computed
///     are off: row_budget.hpp.
/// All five are computed for every row and added up in balls.
///
/// **Errors over n steps.** With B = M C, M as computed: e_{m+1} = B e_m + a_{m+1} with |a_m| <= alpha, one vector for all m (c_m increases
/// to its limit): carried_errors.hpp.
///
/// **Cost.** Rows: N x nodes x p products of fixed-point numbers, most of them short: a term of weight W and order k has the words of W
/// rho^-k; then N^2 products for each level and p x nodes for each load. N and the nodes grow like the number of digits. B itself is only
/// needed for the errors, in binary64.
#pragma once

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/carried_errors.hpp"
#include "touchstone/transfer/coefficients.hpp"
#include "touchstone/transfer/row_budget.hpp"
#include "touchstone/transfer/rule.hpp"

#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <vector>

namespace touchstone::transfer {

enum class Scheme { force_weighted, area };

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
    struct Abscissa {
        /// Exact, |tau| <= 1, at most `moved` from what it stands for: below 2^-30, as the budget of abscissae takes for granted.
        Ball tau, moved;
    };
    /// \throws BeyondReach where it is further outside of [-1, 1], or known to less
    static Abscissa abscissa(const Ball& tau);
    /// Bounds of c_0, c_1, ...: the last is one of all further c_m, too.
    static std::vector<Ball> magnitude_bounds(const Ball& G);

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
    static Ratios ratios_of(const std::vector<Point>&); ///< what one rule is to serve
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
        RowSums sums;
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
    Ball value(const Functional&, long n);
    Row row(const Ball& x, const Ball& s, const Rule&) const;
    Resolution resolution() const;
    const Ball& magnitude(long m) const;
    bool rule_serves(const Ball& x) const;
    double nodal(const mp_limb_t* moments, std::vector<double>& near) const;
    void extend_to(long n);

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
    CarriedErrors carried_;               ///< in units 2^-error_unit_
    Budget worst_;                        ///< componentwise largest over the rows
    std::vector<Ball> c_;                 ///< magnitude_bounds
    Ball scale_;                          ///< power of two >= every c_m
    long error_unit_;
    std::vector<std::vector<mp_limb_t>> levels_; ///< coefficients of the polynomials through the values of F_m/scale at the nodes, by block
    std::list<Step> steps_; ///< most recently used first
    std::mutex mutex_;
};

} // namespace touchstone::transfer
