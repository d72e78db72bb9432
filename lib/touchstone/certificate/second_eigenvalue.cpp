// SPDX-License-Identifier: MIT
#include "touchstone/certificate/second_eigenvalue.hpp"

#include "touchstone/certificate/text.hpp"
#include "touchstone/limit/eigenfunction.hpp"
#include "touchstone/limit/second_eigenvalue.hpp"
#include "touchstone/scalar/rational.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::certificate {
namespace {

constexpr long most_log2_of_G = 20;
constexpr long spare_digits = 1;  ///< the error is a defect over a distance of two eigenvalues, which is 1/80 where G = 2.2
constexpr long bits_for_search = 192, bits_for_checker = 256;
constexpr long kept_bits = 64;    ///< of the coefficients
constexpr double inside = 0x1p-12; ///< the last s is so much before the end of the interval on which w is a polynomial

void write(const Root& root, long digits, std::size_t claim, std::string& head, Lines& lines)
{
    const WorkingPrecision precision(bits_for_search);
    const Ball G = number(root);
    const Accuracy accuracy{digits + spare_digits};
    const limit::Eigenfunction w = limit::approximate_eigenfunction(G, accuracy);
    const Ball lambda = limit::prove_eigenvalue(G, w, accuracy).lambda;

    const Rational last = exact_rational(std::floor(limit::highest_sigma(accuracy) / inside - 1) * inside);
    const Rational low = exact_rational(w.low), high = exact_rational(w.high);
    std::string data = fmt::format("claim={} high={} centre={} radius={} exponent={}", claim, dyadic(last), dyadic((low + high) / 2),
                                   dyadic((high - low) / 2), -kept_bits);
    for (const Ball& c : w.value) data += ' ' + hex(units(c, kept_bits));
    const std::size_t first = lines.add("steady", {}, fmt::format("G={} bits={:x}", named(root), bits_for_checker));
    lines.add("eigenvalue", {first}, data);
    const Rational error = rounded_up(nearest(lambda) * std::pow(10.0, -static_cast<double>(digits)) / 2);
    head += fmt::format("claim {} G={} value={} error={}\n", claim, named(root), dyadic_midpoint(lambda), dyadic(error));
    head += section_line(claim, first, lines.count(), {{"steadies", 1}, {"eigenvalues", 1}});
}

} // namespace

std::string refusal_of_eigenvalue(const Root& G)
{
    const auto degree = static_cast<long>(G.degree);
    Rational most(1);
    mpz_mul_2exp(most.get_num_mpz_t(), most.get_num_mpz_t(), static_cast<mp_bitcnt_t>(most_log2_of_G * degree));
    return power(Rational(11, 5), degree) <= G.base && G.base <= most ? ""
                                                                      : "the second eigenvalue has a certificate where 2.2 <= G <= 2^20";
}

std::string second_eigenvalues(const std::vector<Root>& all, Accuracy wanted)
{
    std::string head;
    Lines lines;
    for (std::size_t i = 0; i < all.size(); ++i) write(all[i], wanted.digits, i + 1, head, lines);
    return certificate_text("limit.gap", all.size(), all.size(), head, lines);
}

} // namespace touchstone::certificate
