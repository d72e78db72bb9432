// SPDX-License-Identifier: MIT
/// \file
/// Integrals along polygonal paths in the complex plane.
///
///     const Integral I = integrate_along(parse_expression("1/x"), {parse_vertex("1"), parse_vertex("i"), parse_vertex("-1")});
///
/// On the segment from a to b, x = a + (b - a) t, 0 <= t <= 1, and what is integrated over t is f(x) (b - a): a complex formula in a real
/// variable, with every rule and proof of integrate.hpp (tanh_sinh.md, section 14). Exact vertices keep their zeros: 1/sqrt(1 + x^2) from 0
/// to i is certified. The branches of functions are the principal ones; a path that meets a cut is refused.
#pragma once

#include "touchstone/quadrature/integrate.hpp"

namespace touchstone::quadrature {

/// A point of the plane, or infinity in a direction.
struct Vertex {
    ExpressionPtr point;     ///< null at infinity
    ExpressionPtr direction; ///< at infinity
    bool is_real = false;
    std::string text;
};

/// `1+i`, `exp(i*pi/3)`, `inf`, `-inf`, `i*inf`, `(1+i)*inf`. \throws ExpressionError
Vertex parse_vertex(std::string_view text, const Parameters& = {});

/// A real vertex as an end of a range.
Limit limit_of(const Vertex&);

/// The value has its digits relative to its modulus. On the real line it is what integrate() gives.
/// Errors: DomainError for fewer than two vertices, two neighbours at infinity, break points or poles on a path that is not one real range.
Integral integrate_along(const ExpressionPtr&, const std::vector<Vertex>& path, const IntegralOptions& = {});

} // namespace touchstone::quadrature
