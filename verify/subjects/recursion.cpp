// SPDX-License-Identifier: GPL-3.0-or-later
/// The recursion (6.1)-(6.7) in double precision on the GNU Scientific Library, as a user of the paper would program
/// it: the density of the pressure is tabulated scale by scale and integrated against the next wave's kernel. Nothing
/// of Touchstone's library is used or linked. Partial contact only: gamma^(D-1) = G > 2, load <= 1.
///
/// Ratios z = p_k/p*_{k+1}, so that p*_{k+1} = G p*_k is the only parameter. Near p = 0 the density rises like p, and near
/// p_k^max it falls like (p_k^max - p)^((k-1)/2); so what is tabulated is g_k in
///
///     density of z = y t^(k-1) g_k,    y = z/z_max,   t^2 = 1 - y^2,
///
/// by Chebyshev series (gsl_cheb) on panels of y^2 and, in the upper half, of t^2, halved until the last coefficients are
/// small. With z = lo + (z_max - lo) sin^2 a, lo = p^2/4, the integrand of (6.2) is smooth at both ends, and
/// gsl_integration_qag does the rest.
#include "verify/subjects/rows.hpp"

#include <gsl/gsl_chebyshev.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <memory>

using touchstone::subjects::Row;
using Function = std::function<double(double)>;

namespace {

constexpr double accuracy = 1e-13;

double call(double x, void* f) { return (*static_cast<Function*>(f))(x); }

/// Over 0 ... pi/2.
double integral(Function f)
{
    constexpr std::size_t panels = 400;
    static const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(
        gsl_integration_workspace_alloc(panels), gsl_integration_workspace_free);
    gsl_function F{call, &f};
    double value = GSL_NAN, error = 0;
    gsl_integration_qag(&F, 0, M_PI_2, 0, accuracy, panels, GSL_INTEG_GAUSS31, space.get(), &value, &error);
    return value; // where roundings keep it from reaching the accuracy asked for, the best it could do
}

/// A function on [0, 1/2] by Chebyshev panels.
class Table {
public:
    explicit Table(const Function& f) { panel(f, 0, 0.5, 1, 0); }
    double operator()(double x) const
    {
        const auto at = std::prev(panels_.upper_bound(std::clamp(x, 0.0, 0.5)));
        return gsl_cheb_eval(at->second.get(), x);
    }

private:
    using Series = std::unique_ptr<gsl_cheb_series, void (*)(gsl_cheb_series*)>;
    void panel(const Function& f, double a, double b, double before, int depth)
    {
        constexpr std::size_t order = 24;
        Series s(gsl_cheb_alloc(order), gsl_cheb_free);
        Function copy = f;
        gsl_function F{call, &copy};
        gsl_cheb_init(s.get(), &F, a, b);
        double last = 0;
        for (std::size_t k = order - 2; k <= order; ++k) last = std::max(last, std::fabs(s->c[k]));
        last /= std::fabs(s->c[0]);
        const bool noise = last < 1e-11 && last > before / 4; // halving no longer helps
        if (last > accuracy && !noise && depth < 40) {
            panel(f, a, (a + b) / 2, last, depth + 1);
            panel(f, (a + b) / 2, b, last, depth + 1);
        }
        else panels_.emplace(a, std::move(s));
    }
    std::map<double, Series> panels_;
};

/// (2.17) by its numerator times conjugate, p above the edge by `below` = 4 load - p^2
double exceedance_of_wave(double p, double load, double below)
{
    const double R = std::hypot(1 - load, p);
    return M_2_PI * std::asin(std::sqrt(std::min(1.0, below / (2 * (1 + load + R)))));
}

/// (2.19) without the factor p/sqrt(4 load - p^2)
double kernel(double p, double load)
{
    const double R = std::hypot(1 - load, p);
    return M_1_PI / R * std::sqrt((1 + load + R) / (1 - load + R));
}

/// All scales of one load and G.
class Surface {
public:
    Surface(double load, double G) : load_(load), G_(G) {}

    double area(std::size_t n) // (6.7)
    {
        if (n == 0) return M_2_PI * std::asin(std::sqrt(load_));
        return over(n - 1, 0, highest(n - 1) / G_, [](double z, double) { return M_2_PI * std::asin(std::sqrt(z)); });
    }
    double exceedance(std::size_t n, double p)
    {
        const double P = p / gsl_pow_uint(G_, static_cast<unsigned>(n)), top = highest(n), below = (top - P) * (top + P);
        if (below <= 0) return 0;
        if (n == 0) return exceedance_of_wave(P, load_, below);
        return over(n - 1, P * P / 4, below / 4, [P](double z, double above) { return exceedance_of_wave(P, z, 4 * above); });
    }
    double density(std::size_t n, double p)
    {
        const double unit = gsl_pow_uint(G_, static_cast<unsigned>(n)), y = p / unit / highest(n), t2 = (1 - y) * (1 + y);
        if (t2 <= 0 || (y <= 0 && (n > 0 || load_ < 1))) return 0;
        return y * std::pow(t2, (static_cast<double>(n) - 1) / 2) * g(n, y * y, t2) / (G_ * unit);
    }

private:
    using Shape = std::function<double(double y2, double t2)>;

    /// p_n^max/p*_n, (5.6); z_max is 1/G of it
    double highest(std::size_t n) const { return 2 * std::sqrt(n == 0 ? load_ : highest(n - 1) / G_); }

    /// g_n(y^2): from (2.19) where n = 0, else (6.2) over g_{n-1}
    double g(std::size_t n, double y2, double t2)
    {
        const double P = highest(n) * std::sqrt(y2);
        if (n == 0) return G_ * kernel(P, load_);
        const double z_max = highest(n - 1) / G_, lo = z_max * y2, k = static_cast<double>(n); // z_max - lo = z_max t^2
        const Shape before = tabulated(n - 1);
        return 2 * z_max * G_ * integral([&](double a) {
            const double s = std::sin(a), c = std::cos(a), z = lo + z_max * t2 * s * s, y = z / z_max;
            return y * std::pow(c, k - 1) * std::pow(1 + y, (k - 2) / 2) * before(y * y, t2 * c * c * (1 + y)) * kernel(P, z);
        });
    }

    /// The sum of f(z, z - lo) over the ratios z = lo ... lo + width = z_max of scale n.
    double over(std::size_t n, double lo, double width, const std::function<double(double, double)>& f)
    {
        const double z_max = highest(n) / G_, k = static_cast<double>(n);
        const Shape density = tabulated(n);
        return integral([&](double a) {
            const double s = std::sin(a), c = std::cos(a), up = width * s * s, z = lo + up, y = z / z_max,
                         t2 = width / z_max * c * c * (1 + y);
            return f(z, up) * y * std::pow(t2, (k - 1) / 2) * density(y * y, t2) * 2 * s * c * width;
        });
    }

    Shape tabulated(std::size_t n)
    {
        if (n == 0) return [this](double y2, double t2) { return g(0, y2, t2); };
        while (tables_.size() < n) { // each half by the distance from its own end
            const std::size_t k = tables_.size() + 1;
            tables_.emplace_back(Table([this, k](double y2) { return g(k, y2, 1 - y2); }),
                                 Table([this, k](double t2) { return g(k, 1 - t2, t2); }));
        }
        return [&t = tables_[n - 1]](double y2, double t2) { return y2 < t2 ? t.first(y2) : t.second(t2); };
    }

    double load_, G_;
    std::deque<std::pair<Table, Table>> tables_;
};

Surface& surface(double load, double G)
{
    static std::map<std::pair<double, double>, Surface> all;
    return all.try_emplace({load, G}, load, G).first->second;
}

} // namespace

int main(int argc, char** argv)
{
    gsl_set_error_handler_off(); // qag that runs into roundings still answers
    const auto within = [](double load, double G) { return load > 0 && load <= 1 && G > 2; };
    const auto n = [](const Row& r) { return static_cast<std::size_t>(r[0]); };
    const std::map<std::string, std::function<double(const Row&)>> quantities{
        {"contact.area", [&](const Row& r) { return within(r[1], r[2]) ? surface(r[1], r[2]).area(n(r)) : GSL_NAN; }},
        {"contact.exceedance", [&](const Row& r) { return within(r[2], r[3]) ? surface(r[2], r[3]).exceedance(n(r), r[1]) : GSL_NAN; }},
        {"contact.density", [&](const Row& r) { return within(r[2], r[3]) ? surface(r[2], r[3]).density(n(r), r[1]) : GSL_NAN; }},
    };
    const auto chosen = quantities.find(argc == 2 ? argv[1] : "");
    if (chosen == quantities.end()) {
        std::cerr << "usage: recursion QUANTITY: contact.area, .exceedance or .density\n";
        return 64;
    }
    return touchstone::subjects::answer_rows(chosen->second);
}
