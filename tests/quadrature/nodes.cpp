// SPDX-License-Identifier: MIT
// The tables of nodes: what each says against the map computed otherwise, and to as many bits as its weight leaves it.
#include "touchstone/quadrature/nodes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

/// The node's numbers by the map itself.
struct TrueNode {
    Ball left, right, log_left, log_right, cosh;
    double depth = 0;
};

TrueNode truth_at(long k, long m, Side side, Transformation transformation)
{
    const bool logistic = transformation == Transformation::logistic;
    Ball log2;
    arb_const_log2(log2.get(), WorkingPrecision::bits());
    const Ball t = log2 * Ball(side == Side::left ? -k : k) / Ball(m);
    const Ball w = logistic ? t : pi<Ball>() * (exp(t) - exp(-t)) / Ball(2);
    const auto log_of_sum = [](const Ball& x) { return log(Ball(1) + x); };
    return {Ball(1) / (Ball(1) + exp(-w)),
            Ball(1) / (Ball(1) + exp(w)),
            -log_of_sum(exp(-w)),
            -log_of_sum(exp(w)),
            logistic ? Ball(1) : (exp(t) + exp(-t)) / Ball(2),
            std::fabs(arf_get_d(arb_midref(w.get()), ARF_RND_NEAR))};
}

} // namespace

TEST_CASE("a table of nodes, whichever was asked for before it, has what the map has, to the bits that are left of a term")
{
    constexpr long spare = 1300; // bits of what it is held against
    const Exponent exponents[] = {0, {1, 2}, {-1, 2}, {-1, 3}, 2, {-7, 4}, {5, 16}, {3, 32}, {70, 1}, {-131, 2}};
    for (const auto& [m, octaves, bits, decay] : {std::tuple(1L, 4L, 128L, 1.0),
                                                  {1L, 5L, 320L, 0.25},
                                                  {2L, 4L, 128L, 1.0},
                                                  {8L, 3L, 64L, 2.0},
                                                  {13L, 4L, 320L, 1.0},
                                                  {13L, 5L, 128L, 0.125},
                                                  {13L, 4L, 192L, 0.3},
                                                  {8L, 4L, 640L, 1.0},
                                                  {2L, 9L, 128L, 1.0},
                                                  {13L, 4L, 320L, 0.5},
                                                  {1L, 7L, 640L, 1.0}})
        for (const Transformation transformation : {Transformation::tanh_sinh, Transformation::logistic}) {
            const long count = octaves * m * (transformation == Transformation::logistic ? 9 : 1);
            const auto table = NodeTable::get(m, count, bits, decay, transformation);
            CHECK(table->m() == m);
            CHECK(table->count() >= count);
            CHECK(table->count() <= count + count / 8);
            std::vector<long> places{table->count()};
            for (long k = 0; k <= count; k += k < m ? 1 : std::max(1L, count / 11)) places.push_back(k);
            for (const long k : places) {
                CAPTURE(m);
                CAPTURE(bits);
                CAPTURE(k);
                const Side side = k % 2 == 0 ? Side::left : Side::right;
                const Node node(*table, k, side);
                const TrueNode t = [&] {
                    const WorkingPrecision precision(spare);
                    return truth_at(k, m, side, transformation);
                }();
                const double least = std::max(64.0, static_cast<double>(bits) - decay * t.depth / M_LN2);
                const auto is_near = [](const Ball& x, const Ball& truth, double known) {
                    return x.is_finite() && x.overlaps(truth) && static_cast<double>(x.relative_bits()) >= known;
                };
                const WorkingPrecision precision(bits + 40);
                CHECK(is_near(node.distance(Side::left), t.left, least));
                CHECK(is_near(node.distance(Side::right), t.right, least));
                CHECK(is_near(node.logarithm(Side::left), t.log_left, least));
                CHECK(is_near(node.logarithm(Side::right), t.log_right, least));
                CHECK(is_near(node.cosh(), t.cosh, least));
                CHECK(std::fabs(node.depth() - t.depth) <= 1e-9 * t.depth);
                for (const Exponent& p : exponents) {
                    const auto power = [](const Exponent& e, const Ball& logarithm) { return e.ball() * logarithm; };
                    const double of_power = least - 12; // |p| < 2^7 times the error of the distance
                    CHECK(is_near(node.power(Side::left, p), exp(power(p, t.log_left)), of_power));
                    for (const Exponent& q : exponents) {
                        CAPTURE(p.to_string());
                        CAPTURE(q.to_string());
                        const Ball truth = [&] {
                            const WorkingPrecision more(spare);
                            return exp(power(p, t.log_left) + power(q, t.log_right));
                        }();
                        CHECK(is_near(node.monomial(p, q), truth, of_power));
                        CHECK(is_near(node.weighted(p, q), truth * t.cosh * t.left * t.right, of_power));
                    }
                }
            }
        }
}
