// SPDX-License-Identifier: GPL-3.0-or-later
/// The recursion (6.1)-(6.7) where full contact occurs, in double precision on the GNU Scientific Library: any G = gamma^(D-1) > 1, any
/// load. What recursion.cpp is for partial contact; nothing of Touchstone's library is used or linked.
///
/// Backwards, since densities have infinities inside: v_0(x) is the share above p of a wave with mean pressure x (the area is p = 0), and
///
///     v_{k+1}(x) = mean of v_k over one wave of mean x,   in the angle of (2.2) where x >= 1, else (2.4) with sin(pi xi/lambda) = sqrt(x)
///     sin(psi),
///
/// so that Q_n(p) = v_n(load) for v_0 at p/p*_n. Each v_k is tabulated by Chebyshev series (gsl_cheb) in log x on panels that begin at the
/// points where v_0 is not smooth and at their first images, and are halved where needed; integrals are cut at the same points and left to
/// gsl_integration_qag.
#include "verify/subjects/rows.hpp"

#include <gsl/gsl_chebyshev.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <memory>

using touchstone::subjects::Row;
using Function = std::function<double(double)>;

namespace {

constexpr double accuracy = 1e-13;
constexpr double least = 1e-30; ///< what is below counts as a power of x

double call(double x, void* f) { return (*static_cast<Function*>(f))(x); }

double integral(Function f, double from, double to)
{
    constexpr std::size_t panels = 200;
    static const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(
        gsl_integration_workspace_alloc(panels), gsl_integration_workspace_free);
    gsl_function F{call, &f};
    double value = 0, error = 0;
    gsl_integration_qag(&F, from, to, 0, accuracy, panels, GSL_INTEG_GAUSS21, space.get(), &value, &error);
    return value; // where roundings keep it from reaching the accuracy asked for, the best it could do
}

/// A function of log x on panels.
class Table {
public:
    Table(const Function& f, const std::vector<double>& cuts)
    {
        for (std::size_t i = 1; i < cuts.size(); ++i) panel(f, cuts[i - 1], cuts[i], 1, 0);
    }
    double operator()(double s) const { return gsl_cheb_eval(std::prev(panels_.upper_bound(s))->second.get(), s); }

private:
    using Series = std::unique_ptr<gsl_cheb_series, void (*)(gsl_cheb_series*)>;
    void panel(const Function& f, double a, double b, double before, int depth)
    {
        constexpr std::size_t order = 16;
        Series s(gsl_cheb_alloc(order), gsl_cheb_free);
        Function copy = f;
        gsl_function F{call, &copy};
        gsl_cheb_init(s.get(), &F, a, b);
        double last = 0;
        for (std::size_t k = order - 2; k <= order; ++k) last = std::max(last, std::fabs(s->c[k]));
        if (last > 0) last *= std::sqrt(std::min(1.0, b - a)) / std::fabs(s->c[0]); // the share of a wave that falls there, at most
        const bool noise = last < 1e-11 && last > before / 4;
        if (last > accuracy && !noise && depth < 40) {
            panel(f, a, (a + b) / 2, last, depth + 1);
            panel(f, (a + b) / 2, b, last, depth + 1);
        }
        else panels_.emplace(a, std::move(s));
    }
    std::map<double, Series> panels_;
};

/// The share above p of a wave of mean x, both in units of its p*: (2.12), (2.17) as arctan, which loses nothing at either end.
double share_above(double x, double p)
{
    if (x >= 1) {
        const double above = x + 1 - p, below = p - (x - 1);
        return below <= 0 ? 1 : above <= 0 ? 0 : M_2_PI * std::atan2(std::sqrt(above), std::sqrt(below));
    }
    const double above = 2 * x - p * p / 2, R = std::hypot(1 - x, p);
    return above <= 0 ? 0 : M_2_PI * std::atan2(std::sqrt(above), std::sqrt(1 - x + R + p * p / 2));
}

/// v_0, v_1, ... of one G and one p/p*_n, on the ratios that loads up to `heaviest` lead to.
class Levels {
public:
    Levels(double G, double p, double heaviest)
        : G_(G)
        , p_(p)
        , reach_(std::max({1.0, (heaviest + 1) / G, 1 / (G - 1), 2 / G}) * (1 + 1e-12))
    {
        std::vector<double> last{1};
        if (p > 0) last = p <= 2 ? std::vector{1.0, p * p / 4, p + 1} : std::vector{1.0, p - 1, p + 1};
        for (int generation = 0; generation < 4; ++generation) {
            std::vector<double> next;
            for (const double s : last) {
                if (s <= least || s >= reach_) continue;
                points_.push_back(s);
                next.push_back(G * s + 1);
                next.push_back(G * s >= 2 ? G * s - 1 : G * G * s * s / 4);
            }
            last = next;
        }
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end(), [](double a, double b) { return b - a < 1e-9 * b; }), points_.end());
        cuts_ = {std::log(least)};
        for (const double s : points_) cuts_.push_back(std::log(s));
        if (std::log(reach_) > cuts_.back()) cuts_.push_back(std::log(reach_));
    }

    /// v_{k+1}(x)
    double after(std::size_t k, double x)
    {
        while (tables_.size() < k) {
            const std::size_t m = tables_.size();
            tables_.emplace_back([this, m](double s) { return one_wave(m, std::exp(s)) / std::exp(power(m + 1) * s); }, cuts_);
        }
        return one_wave(k, x);
    }

private:
    /// The area goes like x^power for x -> 0.
    double power(std::size_t k) const { return p_ > 0 ? 0 : 1 - std::ldexp(1, -static_cast<int>(k) - 1); }

    double value(std::size_t k, double x) const
    {
        if (k == 0) return share_above(x, p_);
        return tables_[k - 1](std::log(std::clamp(x, least, reach_))) * std::pow(x, power(k));
    }

    /// The mean of v_k over one wave.
    double one_wave(std::size_t k, double x) const
    {
        const double end = x >= 1 ? M_PI : M_PI_2;
        std::vector<double> angles{0, end};
        for (const double s : points_) { // where it leads to s
            const double c = x >= 1 ? G_ * s - x : (std::hypot(1 - x, G_ * s) - (1 - x)) / (2 * x);
            if (x >= 1 ? std::fabs(c) < 1 : c < 1) angles.push_back(std::acos(x >= 1 ? c : std::sqrt(c)));
        }
        std::sort(angles.begin(), angles.end());
        double sum = 0;
        for (std::size_t i = 1; i < angles.size(); ++i) {
            if (angles[i] - angles[i - 1] < 1e-14) continue;
            sum += integral(
                [&](double angle) {
                    if (x >= 1) return value(k, (x - 1 + 2 * gsl_pow_2(std::cos(angle / 2))) / G_) / M_PI;
                    const double c = std::cos(angle), root = std::sqrt(1 - x + x * c * c);
                    return value(k, 2 / G_ * std::sqrt(x) * c * root) * M_2_PI * std::sqrt(x) * c / (root > 0 ? root : 1);
                },
                angles[i - 1], angles[i]);
        }
        return sum;
    }

    double G_, p_, reach_;
    std::vector<double> points_, cuts_;
    std::deque<Table> tables_;
};

/// Q_n(p); the area if p = 0.
double exceedance(double n, double p, double load, double G)
{
    const double P = p / std::pow(G, n);
    if (n == 0) return share_above(load, P);
    static std::map<std::array<double, 3>, Levels> all;
    const double heaviest = std::max(10.0, load);
    return all.try_emplace({G, P, heaviest}, G, P, heaviest).first->second.after(static_cast<std::size_t>(n) - 1, load);
}

} // namespace

int main(int argc, char** argv)
{
    gsl_set_error_handler_off(); // qag that runs into roundings still answers
    const std::map<std::string, std::function<double(const Row&)>> quantities{
        {"contact.area", [](const Row& r) { return exceedance(r[0], 0, r[1], r[2]); }},
        {"contact.exceedance", [](const Row& r) { return exceedance(r[0], r[1], r[2], r[3]); }},
        {"segments.count", [](const Row& r) { return std::pow(r[3], r[0]) * exceedance(r[0] - 1, 0, r[1], std::pow(r[3], r[2] - 1)); }},
    };
    const auto chosen = quantities.find(argc == 2 ? argv[1] : "");
    if (chosen == quantities.end()) {
        std::cerr << "usage: recursion_full_contact QUANTITY: contact.area, contact.exceedance or segments.count\n";
        return 64;
    }
    return touchstone::subjects::answer_rows(chosen->second);
}
