// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/symbolic/units.hpp"

#include "proofs/symbolic/symbolic.hpp"

#include <optional>
#include <stdexcept>

namespace touchstone::proofs {

namespace {

using GiNaC::is_a;

/// pressure^p length^l; a force on a plane (two-dimensional) body is pressure times length.
/// The powers are expressions because the paper raises to symbolic powers.
struct Dimension {
    ex pressure = 0, length = 0;
    bool is_number() const { return same(pressure, 0) && same(length, 0); }
    bool operator==(const Dimension& o) const { return same(pressure, o.pressure) && same(length, o.length); }
    std::string text() const { return is_number() ? "a number" : "pressure^(" + str(pressure) + ") length^(" + str(length) + ")"; }
    static bool same(const ex& a, const ex& b) { return GiNaC::normal(GiNaC::expand(a - b)).is_zero(); }
};

class Mismatch : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

const Dimension number{}, pressure{1, 0}, length{0, 1};

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
            product.pressure += d->pressure;
            product.length += d->length;
        }
        return product;
    }
    if (is_a<GiNaC::power>(e)) {
        const auto exponent = of(e.op(1), print);
        if (exponent && !exponent->is_number()) throw Mismatch("the exponent " + str(e.op(1)) + " is " + exponent->text());
        const auto base = of(e.op(0), print);
        if (!base) return std::nullopt;
        return Dimension{base->pressure * e.op(1), base->length * e.op(1)};
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

Dimension of_function(const std::string& f)
{
    if (f == "z") return length;
    if (f == "q" || f == "q_nm1") return {-1, 0};
    if (f == "f" || f == "Q" || f == "Q_nm1") return number;
    throw std::invalid_argument("no dimension for the function " + f);
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
            const Dimension wanted = f == "z" ? length : f == "f" ? number : pressure;
            if (!(argument == wanted)) throw Mismatch("the argument of " + f + " is " + argument.text());
            return of_function(f);
        }
        if (kind == "derivative") {
            const Dimension top = print.text(name + ".of") == "N_n" ? Dimension{0, -1} : number;
            const Dimension by = must(field("by"), print);
            return {top.pressure - by.pressure, top.length - by.length};
        }
        if (kind == "integral") {
            const Dimension v = must(field("variable"), print);
            for (const char* end : {"from", "to"}) {
                if (print.text(name + "." + end) == "infinity") continue;
                const auto d = of(field(end), print);
                if (d && !(*d == v)) throw Mismatch("the limit " + print.text(name + "." + end) + " of an integral over " + v.text() + " is " + d->text());
            }
            const Dimension integrand = must(field("integrand"), print);
            return {integrand.pressure + v.pressure, integrand.length + v.length};
        }
        throw std::invalid_argument("no dimension for the piece " + name);
    }
    static const std::map<std::string, Dimension> known = [] {
        std::map<std::string, Dimension> m;
        for (const char* s : {"p", "pbar", "pstar", "pmax", "E", "phat", "p_n", "p_nm1", "p_0", "pstar_n", "pstar_np1", "pstar_0", "pmax_n", "pmax_nm1", "mean_p_n"}) m[s] = pressure;
        for (const char* s : {"x", "g", "lambda", "a", "z", "g_0", "lambda_0", "g_n", "lambda_n", "zhat", "g_nm1", "lambda_nm1", "lambda_np1", "lambda_1", "g_1", "a_0", "a_n", "amax_n", "A", "A_n", "A_0", "A_np1", "A_nm1", "L", "x_centre"}) m[s] = length;
        for (const char* s : {"q", "q_n", "q_nm1"}) m[s] = {-1, 0};
        for (const char* s : {"F_0", "F_1", "F_np1"}) m[s] = {1, 1};
        for (const char* s : {"N_n", "Nhat_n"}) m[s] = {0, -1};
        for (const char* s : {"Q", "I1", "I2", "nu", "D", "gamma", "n", "i", "S", "f", "x_n", "x_nm1", "x_P", "ptilde", "alpha_n", "beta_n", "delta_n", "alpha_np1", "beta_np1", "delta_np1", "K_n", "K_np1", "K_nm1", "K_infinity", "K_0", "rho", "xi", "epsilon", "N", "Nlim", "d_A", "alpha_0", "beta_0", "delta_0"}) m[s] = number;
        m["I1"] = m["I2"] = {-1, 0};
        return m;
    }();
    const auto found = known.find(name);
    if (found == known.end()) throw std::invalid_argument("no dimension for " + name);
    Dimension d = found->second;
    // In (5.3)-(5.9) x is the ratio of pressures and f its function; in (9.3) the densities count peaks.
    if (print.section == "5" && name == "x") return number;
    return d;
}

} // namespace

Check units(const Print& print)
{
    try {
        for (std::size_t i = 0; i < print.parts(); ++i) {
            const std::string part = std::to_string(i);
            const auto left = of(print(part + ".lhs"), print), right = of(print(part + ".rhs"), print);
            if (left && right && !(*left == *right)) throw Mismatch("the left side is " + left->text() + ", the right side " + right->text());
        }
    } catch (const Mismatch& m) {
        return {Verdict::refuted, m.what()};
    }
    return {Verdict::proved, "dimensions agree"};
}

} // namespace touchstone::proofs
