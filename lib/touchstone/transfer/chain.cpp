// SPDX-License-Identifier: MIT
#include "touchstone/transfer/chain.hpp"

namespace touchstone::transfer {

Ball upper(const Ball& x)
{
    Ball r;
    arb_get_ubound_arf(arb_midref(r.get()), x.get(), 30);
    return r;
}

Ball lower(const Ball& x)
{
    Ball r;
    arb_get_lbound_arf(arb_midref(r.get()), x.get(), 30);
    return r;
}

bool Ratios::at_one() const { return arb_is_one(highest.get()) != 0; }

Ball Ratios::zeros() const
{
    if (at_one()) return Ball(0);
    Ball r = 1 / sqrt(1 - highest);
    arb_acosh(r.get(), r.get(), WorkingPrecision::bits());
    return r;
}

Ball largest_product(const ComplexBall& z, const Ball& highest)
{
    const Ball least = lower(abs(z)); // the smallest z of the ball leaves room for the largest x
    const Ball in_disc = arb_is_positive(least.get()) ? at_most(highest, 1 / least) : highest;
    return at_least(highest * abs(1 - highest * z), in_disc / 2);
}

ChainBounds chain_bounds(const ComplexBall& v, const Ball& G, const Ratios& x)
{
    const Ball& X = x.highest;
    const Ball re = v.real();
    Ball sh, co;
    arb_sinh(sh.get(), re.get(), WorkingPrecision::bits());
    arb_cos(co.get(), v.imag().get(), WorkingPrecision::bits());
    Ball sh2, co2;
    arb_sqr(sh2.get(), sh.get(), WorkingPrecision::bits());
    arb_sqr(co2.get(), co.get(), WorkingPrecision::bits());

    ChainBounds b;
    b.cosh_squared = sh2 + co2;
    b.factor = Ball(0);
    Ball product = Ball::indeterminate();       // at least x|1 - x tanh^2 v|
    const ComplexBall w = 2 / (exp(v + v) + 1); // 1 - tanh v
    const ComplexBall gap = w * (2 - w);        // 1 - tanh^2 v = sech^2 v
    if (gap.is_finite()) {
        const ComplexBall z = 1 - gap;
        const Ball at_highest = abs((1 - X) + X * gap); // |1 - Xz|
        // |1 - xz| decreases in x until x = Re z/|z|^2
        const Ball re_z = z.real(), abs_z = abs(z);
        if (x.single) {
            b.factor = lower(at_highest);
            product = X * at_highest;
        }
        else {
            if (arb_is_nonpositive(re_z.get())) b.factor = Ball(1);
            else if (certainly(less(X * abs_z * abs_z, re_z))) b.factor = lower(at_highest);
            else b.factor = lower(abs(z.imag()) / abs_z);
            product = largest_product(z, X);
        }
        if (!b.factor.is_finite() || arb_is_negative(b.factor.get())) b.factor = Ball(0);
    }
    if (x.single && x.at_one()) b.factor = lower(1 / b.cosh_squared);
    // far to the right |tanh v| <= coth Re v
    if (arb_is_positive(re.get())) {
        const Ball far = lower((1 - X) - X / sh2); // 1 - X coth^2
        if (far.is_finite() && certainly(less(b.factor, far))) b.factor = far;
    }
    b.modulus = upper(2 / G * sqrt(product / b.cosh_squared));
    return b;
}

} // namespace touchstone::transfer
