// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/symbolic/units.hpp"

#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbols.hpp"

#include <map>
#include <optional>
#include <regex>
#include <stdexcept>

namespace touchstone::proofs {

namespace {

using GiNaC::is_a;

/// Powers of base dimensions: pressure and length in the paper, where a force on a plane (two-dimensional) body is pressure times length.
/// The powers are expressions because the paper raises to symbolic powers.
struct Dimension {
    std::map<std::string, ex> powers;
    ex power(const std::string& base) const
    {
        const auto found = powers.find(base);
        return found == powers.end() ? ex(0) : found->second;
    }
    bool is_number() const { return *this == Dimension{}; }
    bool operator==(const Dimension& o) const
    {
        for (const Dimension* d : {this, &o})
            for (const auto& [base, p] : d->powers)
                if (!same(power(base), o.power(base))) return false;
        return true;
    }
    Dimension& times(const Dimension& o, const ex& exponent = 1)
    {
        for (const auto& [base, p] : o.powers) powers[base] += p * exponent;
        return *this;
    }
    std::string text() const
    {
        std::string all;
        for (const auto& [base, p] : powers)
            if (!same(p, 0)) all += (all.empty() ? "" : " ") + base + "^(" + str(p) + ")";
        return all.empty() ? "a number" : all;
    }
    static bool same(const ex& a, const ex& b) { return GiNaC::normal(GiNaC::expand(a - b)).is_zero(); }
};

/// "force/length^2"
Dimension parsed(const std::string& text)
{
    static const std::regex factor(R"(([*/]?)\s*([A-Za-z_]\w*|1)\s*(?:\^\s*(-?\d{1,6}))?\s*)"); // no quantity has a power of seven digits
    Dimension d;
    std::size_t at = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), factor), end; it != end; ++it) {
        if (static_cast<std::size_t>(it->position()) != at || ((*it)[1].length() == 0) != (at == 0))
            throw std::invalid_argument("not a dimension: '" + text + "'");
        at += static_cast<std::size_t>(it->length());
        if ((*it)[2] == "1") continue;
        const long power = (*it)[3].matched ? std::stol((*it)[3]) : 1;
        d.times(Dimension{{{(*it)[2], 1}}}, (*it)[1] == "/" ? -power : power);
    }
    if (at != text.size() || text.empty()) throw std::invalid_argument("not a dimension: '" + text + "'");
    return d;
}

class Mismatch : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

const Dimension number{};

/// The dimension of a symbol by its name in the paper; pieces of the print by their own rule.
Dimension of_symbol(const std::string& name, const Print& print);
std::optional<Dimension> of(const ex& e, const Print& print);

/// nothing for an exact zero, which has every dimension
std::optional<Dimension> of(const ex& e, const Print& print)
{
    if (is_a<GiNaC::numeric>(e)) return e.is_zero() ? std::nullopt : std::optional(number);
    if (is_a<GiNaC::constant>(e)) return number;
    if (is_a<GiNaC::symbol>(e)) return of_symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name(), print);
    if (is_a<GiNaC::add>(e)) {
        std::optional<Dimension> all;
        for (const ex& term : e) {
            const auto d = of(term, print);
            if (!d) continue;
            if (all && !(*all == *d)) throw Mismatch("a sum of " + all->text() + " and " + d->text() + " in " + str(e));
            all = d;
        }
        return all;
    }
    if (is_a<GiNaC::mul>(e)) {
        Dimension product;
        for (const ex& f : e) {
            const auto d = of(f, print);
            if (!d) return std::nullopt;
            product.times(*d);
        }
        return product;
    }
    if (is_a<GiNaC::power>(e)) {
        const auto exponent = of(e.op(1), print);
        if (exponent && !exponent->is_number()) throw Mismatch("the exponent " + str(e.op(1)) + " is " + exponent->text());
        const auto base = of(e.op(0), print);
        if (!base) return std::nullopt;
        return Dimension{}.times(*base, e.op(1));
    }
    if (is_a<GiNaC::function>(e)) {
        for (const ex& x : e) {
            const auto d = of(x, print);
            if (d && !d->is_number()) throw Mismatch("the argument " + str(x) + " of a function is " + d->text());
        }
        return number;
    }
    throw std::invalid_argument("no dimension for " + str(e));
}

Dimension must(const ex& e, const Print& print) { return of(e, print).value_or(number); }

const FunctionKind& kind_of_function(const std::string& f)
{
    const auto found = alphabet().functions.find(f);
    if (found == alphabet().functions.end()) throw std::invalid_argument("no dimension for the function " + f);
    return found->second;
}

Dimension of_symbol(const std::string& name, const Print& print)
{
    const auto field = [&](const char* f) { return print(name + "." + f); };
    if (print.has(name + ".kind")) {
        const std::string& kind = print.text(name + ".kind");
        if (kind == "sum" || kind == "product") return must(field("term"), print);
        if (kind == "limit") return number;
        if (kind == "function") {
            const auto argument = must(field("argument"), print);
            const std::string& f = print.text(name + ".of");
            if (!(argument == parsed(kind_of_function(f).argument))) throw Mismatch("the argument of " + f + " is " + argument.text());
            return parsed(kind_of_function(f).value);
        }
        if (kind == "derivative") {
            return of_symbol(print.text(name + ".of"), print).times(must(field("by"), print), -1);
        }
        if (kind == "integral") {
            const Dimension v = must(field("variable"), print);
            for (const char* end : {"from", "to"}) {
                if (print.text(name + "." + end) == "infinity") continue;
                const auto d = of(field(end), print);
                if (d && !(*d == v))
                    throw Mismatch("the limit " + print.text(name + "." + end) + " of an integral over " + v.text() + " is " + d->text());
            }
            const Dimension integrand = must(field("integrand"), print);
            return Dimension(integrand).times(v);
        }
        throw std::invalid_argument("no dimension for the piece " + name);
    }
    const auto found = alphabet().symbols.find(name);
    if (found == alphabet().symbols.end() || !found->second.dimension) throw std::invalid_argument("no dimension for " + name);
    const auto here = found->second.in_section.find(print.section);
    return parsed(here == found->second.in_section.end() ? *found->second.dimension : here->second);
}

} // namespace

Check units(const Print& print)
{
    try {
        for (std::size_t i = 0; i < print.parts(); ++i) {
            const std::string part = std::to_string(i);
            const auto left = of(print(part + ".lhs"), print), right = of(print(part + ".rhs"), print);
            if (left && right && !(*left == *right))
                throw Mismatch("the left side is " + left->text() + ", the right side " + right->text());
        }
    } catch (const Mismatch& m) {
        return {Verdict::refuted, m.what()};
    }
    return {Verdict::proved, "dimensions agree"};
}

} // namespace touchstone::proofs
