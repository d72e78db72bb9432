// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=off, as scalar/double_double.hpp asks.
#include "touchstone/limit/mesh.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/singular_points.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::limit {
namespace {

using namespace transfer;
using namespace transfer::levels;

constexpr double same_point = 1e-4;   ///< relative
constexpr double inside = 0.15;       ///< of a panel's width, from where on the distance to a singular point counts; 1/2 would be its edge
constexpr double widest = 0.1;        ///< a panel that no generation has to be known for
constexpr double beyond_highest = 1.04; ///< a narrow panel there
constexpr std::size_t most_panels = 30'000;

/// Of a singular point of this generation, measured on meshes that were halved until sixteen levels of areas were resolved, 1.08 < G < 1.5.
double strength_of(int generation)
{
    double strength = 1;
    for (int g = 1; g <= generation; ++g) strength *= g <= 3 ? 0.2 : 0.055;
    return strength;
}

/// A singular point s of generation g: c w^((g+1)/2) of the function, and w^(1/2) of a wave.
struct Target {
    Real at;
    double scale; ///< lengths are relative to it
    double strength, exponent;
};

class Mesh {
public:
    Mesh(const Ball& G, const Grading& g) : terms(Orders(g.tolerance).terms), left_alone(3 * g.tolerance)
    {
        targets.push_back({0, 1, 1, 1}); // x^(1/2) of the function
        int generations = 1;
        while (generations < most_generations && what_is_left(strength_of(generations), exponent_of(generations), widest) > 1)
            ++generations;
        for (const SingularPoint& s : area_points(G, {Ball::exactly(g.highest), generations, same_point}, g.further))
            add(s.position, s.generation);
    }
    bool too_wide(const Panel& p) const
    {
        const double width = double(p.z1 - p.z0); // polynomials are in z = y^2
        return std::any_of(targets.begin(), targets.end(), [&](const Target& s) {
            const double left = what_is_left(s.strength, s.exponent, p.width() / s.scale);
            if (left <= 1) return false;
            const double rho = std::pow(std::min(left, 1 / left_alone), 1. / terms),
                         distance = std::max({0.0, double((s.at - p.y1) * (s.at + p.y1)), double((p.y0 - s.at) * (p.y0 + s.at))});
            return width * (overlap * (rho + 1 / rho) / 4 - inside) > distance; // coefficients fall like rho^-terms
        });
    }

private:
    static constexpr int most_generations = 20;
    static double exponent_of(int generation) { return generation / 2. + 1; }
    double what_is_left(double strength, double exponent, double width) const { return strength * std::pow(width, exponent) / left_alone; }
    void add(const Ball& s, int generation)
    {
        const Real at = to_real(s);
        const double scale = std::pow(std::min(1.0, double(at)), generation / (generation + 2.)); // s^(1/2) (w/s)^((g+1)/2) w^(1/2)
        if (at > 0) targets.push_back({at, scale, strength_of(generation), exponent_of(generation)});
    }
    int terms;
    double left_alone;
    std::vector<Target> targets;
};

} // namespace

std::vector<Panel> graded_panels(const Ball& G, const Grading& g)
{
    const Mesh mesh(G, g);
    std::vector<Panel> waiting, done;
    for (Real y = g.lowest; y < g.highest;) {
        const Real next = y * (1 + std::min(0.6, 0.35 / double(y)));
        waiting.push_back(panel(y * y, next * next, waiting.empty()));
        y = next;
    }
    for (int beyond = 0; beyond < 2;
         ++beyond) { // beyond the last one functions jump to 0, which counts wherever an end of a wave is within two panels of it
        const Real last = waiting.back().z1;
        waiting.push_back(panel(last, last * beyond_highest, false));
    }
    const Real lowest = waiting.front().z0;
    while (!waiting.empty()) {
        const Panel p = waiting.back();
        waiting.pop_back();
        if (!mesh.too_wide(p) || p.width() <= 8 * narrowest * double(p.y1)) {
            done.push_back(p);
            if (done.size() > most_panels) throw BeyondReach("the mesh would be too large");
            continue;
        }
        const Real middle = (p.z0 + p.z1) * 0.5;
        waiting.push_back(panel(p.z0, middle, p.z0 == lowest));
        waiting.push_back(panel(middle, p.z1, false));
    }
    std::sort(done.begin(), done.end(), [](const Panel& a, const Panel& b) { return a.z0 < b.z0; });
    return done;
}

} // namespace touchstone::limit
