// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

namespace touchstone::transfer::from_the_edge {

double product_of_bounds(std::initializer_list<double> factors)
{
    double r = 1;
    for (const double f : factors) {
        r *= std::max(f, smallest_bound);
        r = r <= infinity ? std::max(r, smallest_bound) : infinity; // inf 0 is not a number
    }
    return r;
}

double above(const Ball& x)
{
    if (!x.is_finite()) return infinity;
    return arf_get_d(arb_midref(upper(x).get()), ARF_RND_UP);
}

double at_most_modulus(const Disc& z)
{
    const double most = up(z.most());
    return std::isfinite(most) ? std::max(most, smallest_bound) : infinity;
}

/// |centre|, but for its rounding.
static double size_of(const Disc& z) { return down(std::sqrt(std::norm(z.centre()))); }

double at_least_modulus(const Disc& z)
{
    const double least = down(size_of(z) - z.radius());
    return least > 0 ? std::min(least, 1 / smallest_bound) : 0;
}

bool meets_cut(const Disc& z)
{
    const double away = z.centre().real() >= 0 ? size_of(z) : std::fabs(z.centre().imag());
    return !(z.radius() < away);
}

Disc disc(double re, double im, double radius) { return {{re, im}, radius}; }
Disc disc(const Ball& x) { return {{about(x), 0}, mag_get_d(arb_radref(x.get()))}; }
Disc disc_over(double from, double to) { return {{(from + to) / 2, 0}, (to - from) / 2}; }

Disc exponential_mean(const Disc& z)
{
    const double m = at_most_modulus(z);
    if (m > 0.8) return (1 - exp(0 - z)) / z;
    return disc(1, 0, m < 1e-3 ? m : up(std::expm1(m) / m - 1));
}

Disc disc_about(double inner, double outer, double from, double to)
{
    const double r = (inner + outer) / 2, a = (from + to) / 2, across = 2 * std::sin((to - from) / 4);
    const double radius = std::sqrt(std::pow((outer - inner) / 2, 2) + outer * r * across * across);
    return disc(r * std::cos(a), r * std::sin(a), up(radius));
}

Arc arc_of_ellipse(double mid, double half, double rho, int i, int arcs)
{
    const double phi = std::numbers::pi * (i + 0.5) / arcs, A = (rho + 1 / rho) / 2, B = ellipse_height(rho);
    return {mid + half * A * std::cos(phi), half * B * std::sin(phi), up(half * A * std::numbers::pi / (2 * arcs))};
}

double over_box(double inner, double outer, double from, double to, int depth, const std::function<double(const Disc&)>& f)
{
    const double b = f(disc_about(inner, outer, from, to));
    if (std::isfinite(b) || depth == 0) return b;
    const double r = (inner + outer) / 2, a = (from + to) / 2;
    double most = 0;
    for (int i = 0; i < 4 && std::isfinite(most); ++i) {
        const double r0 = i & 1 ? r : inner, r1 = i & 1 ? outer : r, a0 = i & 2 ? a : from, a1 = i & 2 ? to : a;
        most = std::max(most, over_box(r0, r1, a0, a1, depth - 1, f));
    }
    return most;
}

Sector sector(double a, double b)
{
    const double sine_a = std::sin(a), sine_b = std::sin(b), cosine_a = std::cos(a), cosine_b = std::cos(b);
    return {down(sine_a * sine_a), std::min(1.0, up(sine_b * sine_b)), down(cosine_b * cosine_b), std::min(1.0, up(cosine_a * cosine_a))};
}

double inverse_mean(double size, double cosine) { return size + 1 / cosine; }

double root_departure(double e, double real_part) { return up(4 * std::exp(-2 * real_part) * e / ((1 - e) * (1 - e))); }

PolarRange polar(double re, double im, double radius)
{
    const double r = std::hypot(re, im);
    radius = up(radius) + r * slack;
    if (radius >= r) return {0, r + radius, 0, 3.1415};
    const double a = std::fabs(std::atan2(im, re)), half = std::asin(radius / r); // widened as the radius is, and more
    return {r - radius, r + radius, std::max(0.0, a - half), std::min(3.1415, a + half)};
}

PolarRange polar(const Disc& z)
{
    if (!std::isfinite(z.most())) return {0, infinity, 0, 3.1415};
    return polar(z.centre().real(), z.centre().imag(), z.radius());
}

double Levels::kernel_bound(const Disc& e, const Disc& d, const Disc& s, const Disc& c, double direct, Kind kind) const
{
    const Disc minus_2d = -2 * d, x = e * exp(minus_2d * s);
    return modulus(x, 1 - x, 4 * e * exp(minus_2d), 2 * d * c, direct, kind);
}

double Levels::modulus(const Disc& x, const Disc& one_minus, const Disc& w4, const Disc& D, double direct, Kind kind) const
{
    const Disc R2 = one_minus * one_minus + w4;
    if (meets_cut(R2)) return infinity;
    const Disc R = sqrt(R2), P = 1 + x + R, M = one_minus + R;
    if (meets_cut(P) || meets_cut(M)) return infinity;
    const Disc E = exponential_mean(D);
    if (kind == Kind::share) { // z^2 = 2 x (1 - e^-D)/P = 2 x D E/P, and D's root is cos theta: E must have one too, however small z is
        if (mean_meets_cut(D, E)) return infinity;
        const double z2 = up(2 * at_most_modulus(x) * at_most_modulus(1 - exp(0 - D)) / at_least_modulus(P));
        return z2 < 1 ? up(std::numbers::pi / 2 * std::sqrt(z2)) : infinity; // |arcsin z| <= (pi/2)|z| for |z| < 1
    }
    double inverse = meets_cut(E) ? infinity : up(1 / at_least_modulus(E));
    inverse = std::min(inverse, direct);
    const double square = law == Law::density ? at_most_modulus(P) / at_least_modulus(M) * inverse
                                              : at_most_modulus(P) * at_most_modulus(M) * inverse;
    return up(std::sqrt(square) / at_least_modulus(R));
}

double Levels::first_bound(const Disc& d) const
{
    const Disc x = disc(load), one_minus = disc(1 - load);
    if (full && law == Law::density) { // R = 2 e^-d: v_1 = e^(3d/2) (1 + e^-d)^(1/2)/2 / E(2d)^(1/2)
        const Disc P = 1 + exp(0 - d), E = exponential_mean(2 * d);
        if (meets_cut(P) || meets_cut(E)) return infinity;
        return up(std::sqrt(at_most_modulus(P) / at_least_modulus(E)) / 2);
    }
    const double decay = at_most_modulus(exp(-beta * d));
    if (full && d.centre().real() - d.radius() > 0.5) // arccos(e^(-d/2)), |e^(-d/2)| < 1: at most pi
        return up(decay * std::numbers::pi / std::sqrt(2 * at_least_modulus(d)));
    const Disc w4 = 4 * x * exp(-2 * d);
    if (law == Law::density) return decay * modulus(x, one_minus, w4, 2 * d, infinity, Kind::step);
    const Disc R2 = one_minus * one_minus + w4;
    Disc R;
    if (full) R = 2 * exp(0 - d);
    else {
        if (meets_cut(R2)) return infinity;
        R = sqrt(R2);
    }
    const Disc P = 1 + x + R;
    if (meets_cut(P)) return infinity;
    const Disc E = exponential_mean(2 * d); // z^2 = 4 d x E/P: as in `modulus`, E must have a root
    if (mean_meets_cut(2 * d, E)) return infinity;
    const double z2 = up(2 * above(load) * at_most_modulus(1 - exp(-2 * d)) / at_least_modulus(P));
    if (!(z2 < 1)) return infinity;
    return up(decay * std::numbers::pi / 2 * std::sqrt(2 * above(load) * at_most_modulus(E) / at_least_modulus(P)));
}

double Levels::lookup(const Boxes& boxes, const PolarRange& p) const
{
    if (!std::isfinite(p.outer)) return infinity;
    const int from = shells.shell(down(p.inner)), to = shells.shell(up(p.outer));
    if (to > shells.count()) return infinity;
    double most = 0;
    for (int m = 0; m < n_directions; ++m) {
        if (directions[static_cast<std::size_t>(m) + 1] < p.from || directions[static_cast<std::size_t>(m)] > p.to) continue;
        most = std::max(most, boxes.largest(from, to, m));
    }
    return most;
}

double Levels::reached(const Boxes& boxes, int j, int m, double s0, double s1) const
{
    const double near = 2 * (j == 0 ? 0 : shells.radius(j - 1)) * s0, far = 2 * shells.radius(j) * s1;
    const int j0 = shells.shell(down(near)), j1 = std::min(shells.shell(up(far)), j + Shells::density); // |2 d s| <= 2 |d|
    const double u = boxes.largest(j0, std::min(j1, shells.count()), m);
    return far > shells.radius(shells.count()) ? std::max(u, boxes.far[static_cast<std::size_t>(m)] * std::sqrt(far)) : u;
}

void Levels::fill(Boxes& boxes, double disc_radius,
                  const std::function<double(const Disc&, int shell, int direction, double outer)>& f) const
{
    boxes.bound.assign(static_cast<std::size_t>(shells.count() + 1) * n_directions, infinity);
    boxes.disc = shells.shell(disc_radius * (1 - 1e-6));
    const double whole = f(disc(0, 0, shells.radius(boxes.disc)), boxes.disc, -1, shells.radius(boxes.disc));
    for (int m = 0; m < n_directions; ++m) {
        for (int j = 0; j <= boxes.disc; ++j) boxes.at(j, m) = whole;
        for (int j = boxes.disc + 1; j <= shells.count(); ++j) {
            const double outer = shells.radius(j);
            if (directions[static_cast<std::size_t>(m) + 1] > 1.571 && outer > 2) break;
            const double b = over_box(shells.radius(j - 1), outer, directions[static_cast<std::size_t>(m)],
                                      directions[static_cast<std::size_t>(m) + 1], 2, [&](const Disc& d) { return f(d, j, m, outer); });
            if (!(b < 1e200)) break; // the set stays star-shaped
            boxes.at(j, m) = std::max(b, smallest_bound);
        }
    }
}

std::unique_ptr<Level> Levels::first_level() const
{
    auto level = std::make_unique<Level>();
    level->k = 1;
    level->edge = 2 / G * sqrt(load);
    // (4/pi)/2^(1/2), and (2/pi) 2^(1/2): the same
    level->C = 2 * sqrt(Ball(2)) / Traits::pi();
    level->tail = infinity;
    const WorkingPrecision low(bound_bits);
    level->edge_bound = level->edge + Ball(0);
    fill(level->boxes, 0.25, [this](const Disc& d, int, int, double) { return first_bound(d); });
    // outside: R -> 1 - load
    level->boxes.far.assign(n_directions, infinity);
    const double r = shells.radius(shells.count());
    for (int m = 0; m < n_directions; ++m) {
        const double cosine = std::cos(directions[static_cast<std::size_t>(m) + 1]);
        if (cosine <= 0.001 || beta * r * cosine < 4) continue;
        double b = infinity;
        const double decay = std::max(std::exp(-beta * r * cosine), smallest_bound);
        if (full) b = law == Law::density ? std::sqrt(2 * inverse_mean(2 * r, cosine)) / 2 : 4 * decay;
        else {
            const double eta = root_departure(load_d, r * cosine);
            if (eta < 1e-3 * (1 - load_d)) b = decay * far_kernel(load_d, eta) * std::sqrt(inverse_mean(2 * r, cosine)) * 2;
        }
        level->boxes.far[static_cast<std::size_t>(m)] = std::max(up(b / std::sqrt(r)), smallest_bound);
    }
    estimate_first(*level);
    return level;
}

double Levels::far_kernel(double e, double eta) const
{
    const double P = 2 + 2 * eta, R = 1 - eta; // R over 1 - x
    return up(law == Law::density ? std::sqrt(P / ((1 - e) * (2 - eta))) / ((1 - e) * R) : std::sqrt(P * (2 + eta) / (1 - e)) / R);
}

std::array<double, Levels::sectors> Levels::sector_shares(long m)
{
    std::array<double, sectors> share{};
    constexpr int fine = 48;
    const double h = std::numbers::pi / 2 / (sectors * fine);
    for (int i = 0; i < sectors * fine; ++i)
        share[static_cast<std::size_t>(i / fine)] += std::pow(std::sin((i + 1) * h), static_cast<double>(m)) * h;
    const WorkingPrecision low(bound_bits);
    const double whole = about(wallis(m));
    for (double& s : share) s = up(s / whole);
    return share;
}

void Levels::bound_boxes(const Level& from, Level& to) const
{
    const WorkingPrecision low(bound_bits);
    const auto share = sector_shares(power(from.k));
    const Disc e = disc(from.edge_bound);
    const double e_d = above(from.edge_bound);
    const double end = shells.radius(shells.count());

    const std::function<double(const Disc&, double, double, double, int)> kernel_over =
        [&](const Disc& d, double a, double b, double direct, int depth) -> double { // theta in [a, b]
        const auto [s0, s1, c0, c1] = sector(a, b);
        const double bound = kernel_bound(e, d, disc_over(s0, s1), disc_over(c0, c1), direct);
        if (std::isfinite(bound) || depth == 0) return bound;
        const double mid = (a + b) / 2;
        const double left = kernel_over(d, a, mid, direct, depth - 1);
        return std::isfinite(left) ? std::max(left, kernel_over(d, mid, b, direct, depth - 1)) : left;
    };

    fill(to.boxes, shells.radius(from.boxes.disc) / 2, [&](const Disc& d, int j, int m, double outer) {
        const double decay = at_most_modulus(exp(-beta * d));
        const double cosine = m < 0 ? -1 : std::cos(directions[static_cast<std::size_t>(m) + 1]);
        double sum = 0;
        for (int i = 0; i < sectors; ++i) {
            const double a = std::numbers::pi / 2 * i / sectors, b = std::numbers::pi / 2 * (i + 1) / sectors;
            const auto [s0, s1, c0, c1] = sector(a, b);
            const double u = m < 0 ? from.boxes.at(from.boxes.disc, 0) : reached(from.boxes, j, m, s0, s1);
            if (!std::isfinite(u)) return infinity;
            const double direct = cosine > 0.001 ? inverse_mean(2 * outer * c1, cosine) : infinity;
            const double k = kernel_over(d, a, b, up(direct), 5);
            if (!std::isfinite(k)) return infinity;
            sum += product_of_bounds({share[static_cast<std::size_t>(i)], k, u});
        }
        return up(decay * sum);
    });
    to.boxes.far.assign(n_directions, infinity);
    for (int m = 0; m < n_directions; ++m) {
        const double cosine = std::cos(directions[static_cast<std::size_t>(m) + 1]);
        if (cosine <= 0.001 || beta * end * cosine < 4) continue;
        const double eta = root_departure(e_d, end * cosine);
        if (!(eta < 1e-3) || e_d > 0.99999) continue; // R^2 = (1-x)^2 (1 + eta') off its cut: 2 arcsin e + eta < pi
        const double beyond = from.boxes.far[static_cast<std::size_t>(m)] * std::sqrt(2 * end);
        const double u = std::max(from.boxes.largest(0, shells.count(), m), beyond);
        const double kernel = up(far_kernel(e_d, eta) * std::sqrt(inverse_mean(2 * end, cosine)) / std::sqrt(end));
        to.boxes.far[static_cast<std::size_t>(m)] = product_of_bounds({std::exp(-beta * end * cosine), kernel, u});
    }
}

} // namespace touchstone::transfer::from_the_edge
