// SPDX-License-Identifier: MIT
/// \file
/// A place that is given, to ask what numbers with endpoint behaviour are there.
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"

/// Where u is a given number, with a logarithm of u and of 1 - u each on a sheet of its own; or where logarithms are kept as symbols.
template <class V>
class Place : public touchstone::quadrature::Frame<V> {
    using Side = touchstone::quadrature::Side;
    using Exponent = touchstone::quadrature::Exponent;

public:
    Place(V u, V log_u, V log_r = V::indeterminate())
        : u_(std::move(u))
        , log_u_(std::move(log_u))
        , log_r_(std::move(log_r))
    {
    }
    explicit Place(V u)
        : u_(std::move(u))
        , log_u_(V::indeterminate())
        , log_r_(V::indeterminate())
        , keeps_(true)
    {
    }

    V distance(Side s) const override { return s == Side::left ? u_ : V(1) - u_; }
    V logarithm(Side s) const override { return s == Side::left ? log_u_ : log_r_; }
    bool keeps_logarithms() const override { return keeps_; }

    touchstone::quadrature::EndpointNumber<V> left(const Exponent& e = 1) const { return {this, {e, {}}, {}, V(1)}; }
    touchstone::quadrature::EndpointNumber<V> right(const Exponent& e = 1) const { return {this, {}, {e, {}}, V(1)}; }

private:
    V u_, log_u_, log_r_;
    bool keeps_ = false;
};

inline touchstone::ComplexBall turns(long n) { return {touchstone::Ball(0), touchstone::pi<touchstone::Ball>() * touchstone::Ball(2 * n)}; }

inline bool holds(const touchstone::Ball& found, const touchstone::ComplexBall& truth)
{
    return found.is_finite() && found.overlaps(truth.real());
}
inline bool holds(const touchstone::ComplexBall& found, const touchstone::ComplexBall& truth)
{
    return found.is_finite() && found.overlaps(truth);
}

inline slong accuracy(const touchstone::Ball& x) { return x.relative_bits(); }
inline slong accuracy(const touchstone::ComplexBall& z) { return acb_rel_accuracy_bits(z.get()); }
