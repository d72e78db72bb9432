// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/enclosure/quadrature.hpp"

#include "touchstone/quadrature/integrate.hpp"

#include <sstream>

namespace touchstone::proofs {
namespace {

/// GiNaC's own print of it, in which only pi has another name.
std::string typed(const ex& e)
{
    const GiNaC::symbol pi("pi");
    std::ostringstream text;
    text << e.subs(GiNaC::Pi == pi);
    return text.str();
}

} // namespace

Ball integral(const ex& integrand, const ex& variable, const ex& from, const ex& to, const Point& at)
{
    constexpr long digits = 12;
    GiNaC::exmap values;
    for (const auto& [name, value] : at) values[sym(name)] = GiNaC::numeric(value.get_str().c_str());
    const auto exact = [&](const ex& e) { return e.subs(values); };
    const auto end = [&](const ex& e) { return quadrature::parse_limit(typed(exact(e))); };
    const auto f = quadrature::parse_expression(typed(exact(integrand).subs(variable == GiNaC::symbol("x"))));
    return quadrature::integrate(f, end(from), end(to), {.digits = digits}).value;
}

} // namespace touchstone::proofs
