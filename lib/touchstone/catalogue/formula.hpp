// SPDX-License-Identifier: MIT
/// \file
/// Hands the inputs of a quantity to a formula template in the arithmetic wanted. Internal to catalogue/.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

namespace touchstone {

/// The inputs as numbers of type T (Ball or Exact).
template <Scalar T>
class Arguments {
public:
    explicit Arguments(const Inputs& in) : in_(in) {} ///< refers to them
    T operator()(const char* key) const ///< one input by name
    {
        if constexpr (std::same_as<T, Ball>) return in_.ball(key);
        else return T(in_.real(key));
    }
    long integer(const char* key) const { return in_.integer(key); } ///< one that is an integer
    T G() const ///< gamma^(D-1)
    {
        if constexpr (std::same_as<T, Exact>) return in_.G_exact();
        else return in_.G_ball();
    }

private:
    const Inputs& in_;
};

/// The ball route through a formula given as a generic lambda over Arguments<T>.
template <class Formula>
Route through(std::string name, Formula f)
{
    return {std::move(name), [f](const Inputs& in) -> Ball { return f(Arguments<Ball>(in)); }, true};
}

/// The exact value through the same kind of lambda.
template <class Formula>
std::function<Exact(const Inputs&)> exactly(Formula f)
{
    return [f](const Inputs& in) -> Exact { return f(Arguments<Exact>(in)); };
}

/// x_n of (5.6) in exact arithmetic. \throws NotExact where it leaves the set.
Exact exact_iterate(long n, const Inputs&);

} // namespace touchstone
