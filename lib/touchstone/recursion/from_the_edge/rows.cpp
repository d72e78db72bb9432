// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

#include "touchstone/scalar/refusal.hpp"

namespace touchstone::transfer::from_the_edge {

const std::vector<std::pair<Ball, Ball>>& Levels::legendre(long n)
{
    auto& rule = gauss[n];
    if (rule.empty()) {
        rule.resize(static_cast<std::size_t>(n));
        for (long i = 0; i < n; ++i)
            arb_hypgeom_legendre_p_ui_root(rule[static_cast<std::size_t>(i)].first.get(), rule[static_cast<std::size_t>(i)].second.get(),
                                           static_cast<ulong>(n), static_cast<ulong>(i), precision);
    }
    return rule;
}

double Levels::integrand_bound(const Level& from, Kind kind, const Disc& d, const Disc& t) const
{
    const Disc t2 = t * t, q = 1 + t2;
    const double q_least = at_least_modulus(q);
    if (q_least == 0) return infinity;
    const Disc sine = 2 * t / q, cosine = (1 - t2) / q, s = sine * sine, c = cosine * cosine;
    const Disc delta = 2 * d * s;
    double u = lookup(from.boxes, polar(delta));
    if (!std::isfinite(u)) return infinity;
    if (kind == Kind::share) u *= at_most_modulus(cosine) * at_most_modulus(exp(-0.5 * delta));
    const double k = kernel_bound(disc(from.edge_bound), d, s, c, infinity, kind);
    return up(product_of_bounds({2 / q_least, std::pow(at_most_modulus(sine), static_cast<double>(power(from.k))), k, u}));
}

RowRule Levels::make_rule(const Level& from, Kind kind, double low, double high, double around, double tolerance)
{
    RowRule rule{low, high, around, {}};
    double t_end = 1;
    if (from.k >= 2 && 2 * high > delta_max) {
        const double s = delta_max / (2 * high);
        int exponent = 0; // to 20 bits: then 30 bisections leave ends, middles and half-lengths exact, and no gap
        t_end = std::frexp(std::tan(std::asin(std::sqrt(s)) / 2), &exponent);
        t_end = std::ldexp(std::floor(std::ldexp(t_end, 20)), exponent - 20);
        const double sine = 2 * t_end / (1 + t_end * t_end);
        rule.reach = down(2 * low * sine * sine);
    }
    const Settings& set = settings(law);
    const long m = power(from.k);
    Ball norm;
    {
        const WorkingPrecision full_precision(precision);
        norm = wallis(m);
    }
    const double norm_d = about(norm);
    if (!(tolerance > 8 * smallest_bound)) throw BeyondReach("so many digits of a distribution would cost too much");
    const Disc d = disc_over(down(low) - around, up(high) + around);
    std::function<void(double, double, int)> pieces = [&](double a, double b, int depth) {
        const double l = (b - a) / 2, mid = (a + b) / 2, goal = tolerance / 8;
        if (std::pow(2 * b, static_cast<double>(m)) < 1e-6) { // perhaps negligible
            const double most = integrand_bound(from, kind, d, disc(mid, 0, up(l)));
            const double whole = up(product_of_bounds({2 * l / norm_d, most}));
            if (whole < goal) {
                rule.error += whole;
                return;
            }
        }
        long best = std::numeric_limits<long>::max();
        double best_error = infinity;
        int finite = 0;
        for (const double r : set.piece_rhos) {
            if (ellipse_height(r) * l >= 1) continue; // it may hold t = i: a pole inside, of which the bound on the boundary knows nothing
            constexpr int arcs = 24;
            double most = 0;
            for (int i = 0; i < arcs && std::isfinite(most); ++i) {
                const auto [x, y, radius] = arc_of_ellipse(mid, l, r, i, arcs);
                most = std::max(most, integrand_bound(from, kind, d, disc(x, y, radius)));
            }
            if (!std::isfinite(most)) continue;
            const double front = up(product_of_bounds({16.0 / 3 * l / (norm_d * (1 - 1 / r)), most}));
            const long n = std::max(4L, static_cast<long>(std::ceil((std::log(front) - std::log(goal)) / (2 * std::log(r)))));
            if (n < best) {
                best = n;
                best_error = up(product_of_bounds({front, std::pow(r, -2.0 * static_cast<double>(n))}));
            }
            if (++finite == 3) break;
        }
        if (best > most_gauss) {
            if (depth == 0) throw BeyondReach("the distribution's integrand could not be bounded; the load is too near 1 or G too near 2");
            --depth;
            pieces(mid, b, depth);
            pieces(a, mid, depth);
            return;
        }
        rule.error += best_error;
        const WorkingPrecision full_precision(precision);
        const Ball centre = Ball::exactly(mid), half = Ball::exactly(l);
        for (const auto& [node, weight] : legendre(best)) {
            const Ball t = centre + half * node, q = 1 / (1 + t * t), sine = 2 * t * q, cosine = (1 - t * t) * q;
            Ball w;
            arb_pow_ui(w.get(), sine.get(), static_cast<ulong>(m), precision);
            w = w * half * weight * 2 * q / norm;
            if (kind == Kind::share) w *= cosine;
            rule.nodes.push_back({sine * sine, cosine * cosine, std::move(w)});
        }
    };
    pieces(0, t_end, 30);
    return rule;
}

RowRule Levels::rule_at(const Level& from, Kind kind, const Ball& d, double around)
{
    const double x = about(d);
    const double size = kind == Kind::share ? estimate_share(from, x) : estimate_step(from, x);
    return make_rule(from, kind, x, x, around * x, epsilon * size * (kind == Kind::slope ? around : 1));
}

void Levels::first(const Ball& d, Ball& u, Ball* slope) const
{
    const Ball w = exp(-2 * d), one_minus = 1 - load;
    const Ball R = full ? 2 * exp(-d) : sqrt(one_minus * one_minus + 4 * load * w);
    Ball minus_b;
    {
        const Ball z = -2 * d;
        arb_expm1(minus_b.get(), z.get(), WorkingPrecision::bits());
        minus_b = -minus_b; // 1 - w
    }
    const Ball P = 1 + load + R, M = one_minus + R;
    if (law == Law::density) {
        u = full ? sqrt((1 + exp(-d)) * 2 * d / minus_b) / 2 : exp(-d * 3 / 2) * sqrt(P * 2 * d / (M * minus_b)) / R;
        return;
    }
    const Ball top = 2 * load * minus_b, rest = M + 2 * load * w; // z^2 : 1 - z^2
    const Ball angle = atan2(sqrt(top), sqrt(rest)), v = angle / sqrt(2 * d), decay = exp(-d / 2);
    u = decay * v;
    if (slope) {
        const Ball R_d = -4 * load * w / R, z2_d = 2 * load * (2 * w / P - minus_b * R_d / (P * P));
        const Ball angle_d = z2_d / (2 * sqrt(top * rest) / P);
        *slope = decay * (angle_d / sqrt(2 * d) - v / (2 * d) - v / 2);
    }
}

Levels::Row Levels::row(const Level& from, Kind kind, const Ball& d, const RowRule& rule)
{
    Row out;
    const Ball &e = from.edge, w4 = 4 * e * exp(-2 * d), two_d = 2 * d, one(1);
    const double d_d = about(d);
    const Panel* panel = nullptr;
    std::map<const Panel*, std::pair<std::vector<double>, double>> moments;
    Ball u, u_d, a, b, k_d, sum(0), sum_d(0);
    const bool with_slope = kind == Kind::slope;
    for (const RuleNode& node : rule.nodes) {
        const Ball delta = two_d * node.s, D = two_d * node.c;
        Ball minus = -delta;
        arb_expm1(a.get(), minus.get(), precision);
        minus = -D;
        arb_expm1(b.get(), minus.get(), precision);
        Ball root; // e^(-delta/2), where x itself is to keep its sign
        if (kind == Kind::share) root = exp(-delta / 2);
        const Ball x = kind == Kind::share ? e * root * root : e * (one + a), one_minus = one - x, R = sqrt(one_minus * one_minus + w4),
                   P = one + x + R;
        Ball k;
        if (kind == Kind::share) {
            // z^2 : 1 - z^2
            k = atan2(sqrt(-2 * x * b), sqrt(one_minus + R + 2 * x * (one + b))) * root;
        }
        else {
            const Ball M = one_minus + R;
            k = law == Law::density ? sqrt(-P * D / (M * b)) / R : sqrt(-P * M * D / b) / R;
        }
        k *= node.weight;
        if (with_slope) { // (log k)' at fixed s
            const Ball s2 = 2 * node.s, M = one_minus + R, x_d = -x * s2, R_d = (-one_minus * x_d - w4) / R;
            const Ball E_d = 2 * node.c * (-(one + b) / b - one / D); // of log E
            k_d = ((x_d + R_d) / P + (R_d - x_d) / M - E_d) / 2 - R_d / R;
        }
        const double k_d_d = with_slope ? about(k_d) : 0;
        if (from.k == 1) first(delta, u, with_slope ? &u_d : nullptr);
        else {
            const double at = about(delta);
            if (!panel || at < panel->a || at > panel->b) {
                const auto it =
                    std::lower_bound(from.panels.begin(), from.panels.end(), at, [](const auto& p, double y) { return p->b < y; });
                panel = it == from.panels.end() ? from.panels.back().get() : it->get();
            }
            const Ball xi = ((panel->logarithmic ? log(delta) : delta) - panel->mid) / panel->half;
            if (with_slope) {
                arb_poly_evaluate2(u.get(), u_d.get(), panel->polynomial, xi.get(), wide);
                u_d = u_d / panel->half;
                if (panel->logarithmic) u_d = u_d / delta;
            }
            else evaluate(*panel, xi, u);
            // what the values of the level do to this row
            auto& [moment, weight] = moments[panel];
            moment.resize(static_cast<std::size_t>(panel->points));
            const double size = std::fabs(about(k)), x_d = std::clamp(about(xi), -1.0, 1.0);
            out.interpolation += size * (with_slope ? std::fabs(k_d_d) : 1) * panel->interpolation;
            weight += size * (with_slope ? 1 + std::fabs(k_d_d) + 2 / panel->half_d / (panel->logarithmic ? at : 1) : 1);
            // the row as a functional of T_j: k T_j, or k (2s T_j' + (log k)' T_j)
            const double per = with_slope ? 2 * about(node.s) / panel->half_d / (panel->logarithmic ? at : 1) : 0;
            if (with_slope) out.interpolation += size * per * panel->slope;
            double t0 = 1, t1 = x_d, u0 = 0, u1 = 1; // T_j, T_{j+1}, U_{j-1}, U_j
            for (std::size_t j = 0; j < moment.size(); ++j) {
                moment[j] += with_slope ? about(k) * (per * static_cast<double>(j) * u0 + k_d_d * t0) : size * t0;
                const double t2 = 2 * x_d * t1 - t0, u2 = 2 * x_d * u1 - u0;
                t0 = t1;
                t1 = t2;
                u0 = u1;
                u1 = u2;
            }
        }
        if (with_slope) sum_d += k * (u_d * 2 * node.s + u * k_d);
        sum += k * u;
    }
    for (auto& [p, entry] : moments) {
        auto& [moment, weight] = entry;
        const auto& T = chebyshev_table(p->points);
        const auto n = static_cast<std::size_t>(p->points);
        for (std::size_t j = 0; j < n; ++j) {
            double B = moment[0];
            for (std::size_t i = 1; i < n; ++i) B += 2 * moment[i] * T[i * n + j];
            out.carried += std::fabs(B) / static_cast<double>(n) * p->errors[j];
        }
        out.carried += (at_panel_end + slack * static_cast<double>(n)) * weight * p->worst *
                       static_cast<double>(with_slope ? n * n : 1); // this arithmetic's own rounding
    }
    out.value = sum;
    out.slope = sum_d;
    out.rule_error = rule.holds(d) ? rule.error + dropped(from, kind, d_d, rule.reach) : infinity;
    out.interpolation = up(out.interpolation);
    out.error = up(std::max(out.rule_error + out.interpolation + out.carried, smallest_bound)); // more than what underflowed above
    return out;
}

double Levels::dropped(const Level& from, Kind kind, double d, double reach) const
{
    if (!std::isfinite(reach)) return 0;
    const auto k = static_cast<double>(from.k);
    const double next = log_constant(from); // log(C_{k+1})
    if (law == Law::exceedance) // E_{k+1} = d^((k+1)/2) C_{k+1} v_{k+1}; the derivative is never asked for here
        return kind == Kind::slope ? infinity
                                   : std::exp(0.5 * std::log(about(from.edge)) - reach / 2 - (k + 1) / 2 * std::log(d) - next) * (1 + 1e-6);
    if (kind == Kind::share) return infinity; // its caller adds its own
    const double k2 = 4 / std::numbers::pi * std::pow(1 - above(from.edge_bound), -1.5);
    return product_of_bounds({4.1 * k2 * from.tail, std::exp(-reach - (k - 1) / 2 * std::log(d) - next)}) * (1 + 1e-6);
}

double Levels::log_constant(const Level& from) const
{
    const WorkingPrecision low(60);
    return about(log(constant_after(from)));
}

Ball Levels::constant_after(const Level& from) const
{
    const long k = from.k;
    Ball step = sqrt(Traits::power_of_two(k + 1)) * wallis(power(k));
    step = law == Law::density ? step * 4 / Traits::pi() : step * sqrt(from.edge) / Traits::pi();
    return from.C * step;
}

} // namespace touchstone::transfer::from_the_edge
