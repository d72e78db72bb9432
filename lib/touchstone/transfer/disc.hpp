// SPDX-License-Identifier: MIT
/// \file
/// Circular arithmetic: discs of complex numbers in binary64 that hold every result for every choice from the operands. Internal to
/// transfer/.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace touchstone::transfer {

/// Centre and radius, the radius enlarged for every rounding, and by more than what can underflow. Numbers below 1e150; a radius that is
/// infinite or not a number: nothing is known. A constant of a formula, 0 or one whose square is far from underflow, is a point.
class Disc {
public:
    Disc(double constant = 0) : c_(constant), r_(0) {}
    Disc(std::complex<double> c, double r) : c_(c), r_(r + tiny * (size(c) + r) + floor) {}
    double most() const { return size(c_) + r_; }
    std::complex<double> centre() const { return c_; }
    double radius() const { return r_; }

    friend Disc operator+(const Disc& a, const Disc& b) { return {a.c_ + b.c_, a.r_ + b.r_}; }
    friend Disc operator-(const Disc& a, const Disc& b) { return {a.c_ - b.c_, a.r_ + b.r_}; }
    friend Disc operator*(const Disc& a, const Disc& b) { return {product(a.c_, b.c_), size(a.c_) * b.r_ + a.r_ * (size(b.c_) + b.r_)}; }
    /// 1/b is the disc about conj(c)/d of radius r/d, d = |c|^2 - r^2. Next to d = 0 that is a difference of rounded numbers: off by less
    /// than 2^-51 |c|^2, which moves centre and radius by as much relative to d.
    friend Disc operator/(const Disc& a, const Disc& b)
    {
        const double squared = std::norm(b.c_), d = squared - b.r_ * b.r_;
        if (!(d > 0x1p-40 * squared)) return {0, unknown};
        const double off = 0x1p-50 * squared / d;
        return a * Disc(std::conj(b.c_) / d, (b.r_ + off * (size(b.c_) + b.r_)) / d);
    }
    /// Analytic, with a positive real part; infinite if the disc meets the negative axis.
    friend Disc sqrt(const Disc& a)
    {
        const double x = a.c_.real(), y = a.c_.imag(), most = size(a.c_);
        if (!(a.r_ < (x >= 0 ? most : std::fabs(y)))) return {0, unknown};
        const double s = std::sqrt((most + std::fabs(x)) / 2), t = y / (2 * s);
        const std::complex<double> root = x >= 0 ? std::complex(s, t) : std::complex(std::fabs(t), std::copysign(s, y));
        // |root| times the most of |(1 + t)^(1/2) - 1| = 1 - (1 - q)^(1/2), |t| <= q = r/|c| rounded up: next to q = 1 it is steep
        const double q = std::min(1.0, a.r_ / most * (1 + 0x1p-49));
        return {root,
                std::sqrt(most) *
                    (1 - std::sqrt(1 - q))}; // the roundings here are below 8 2^-53 |root|, and a disc is enlarged by four times as much
    }
    /// About e^c, |e^(c + t) - e^c| <= |e^c| (e^r - 1); where e^c is small, about 0, |e^z| <= e^(Re c + r), a sum off by 2^-44 at most;
    /// below e^-300 only that. exp, expm1, sin and cos are taken to be right to 2^-50.
    friend Disc exp(const Disc& a)
    {
        const double x = a.c_.real(), y = a.c_.imag(), most = x + a.r_;
        if (!(most < 300)) return {0, unknown};
        if (x < -300) return {0, most < -300 ? 0x1p-432 : std::exp(most) * (1 + 0x1p-40)};
        const double s = std::exp(x);
        return {std::complex(s * std::cos(y), s * std::sin(y)), s * std::expm1(a.r_)};
    }

private:
    static constexpr double tiny = 0x1p-48, floor = 1e-160, unknown = std::numeric_limits<double>::infinity();
    static double size(std::complex<double> c) { return std::sqrt(std::norm(c)); }
    static std::complex<double> product(std::complex<double> a, std::complex<double> b)
    {
        return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
    }
    std::complex<double> c_;
    double r_;
};

} // namespace touchstone::transfer
