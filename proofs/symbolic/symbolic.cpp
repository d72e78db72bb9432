// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/symbolic/symbolic.hpp"

#include <sstream>
#include <stdexcept>

namespace touchstone::proofs {

using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

std::string str(const ex& e)
{
    std::ostringstream out;
    out << e;
    return out.str();
}

namespace {

/// Apply f to every node, children first.
ex bottom_up(const ex& e, const std::function<ex(const ex&)>& f)
{
    struct Map : GiNaC::map_function {
        const std::function<ex(const ex&)>& f;
        explicit Map(const std::function<ex(const ex&)>& g) : f(g) {}
        ex operator()(const ex& x) override { return f(x.map(*this)); }
    } map(f);
    return map(e);
}

} // namespace

bool is_positive(const ex& e)
{
    if (is_a<numeric>(e)) return ex_to<numeric>(e).is_positive();
    if (is_a<GiNaC::constant>(e)) return true; // pi, Euler's and Catalan's constant
    if (is_a<GiNaC::symbol>(e)) return e.info(GiNaC::info_flags::positive);
    if (is_a<GiNaC::power>(e)) return is_positive(e.op(0)); // to a real power
    if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) {
        for (const ex& part : e)
            if (!is_positive(part)) return false;
        return true;
    }
    if (is_a<GiNaC::function>(e)) {
        const std::string f = ex_to<GiNaC::function>(e).get_name();
        return f == "exp" || (f == "tgamma" && is_positive(e.op(0)));
    }
    return false;
}

namespace {

/// sqrt(q) if q is the square of a monomial with positive rational coefficient. The root of g^2k is |g|^k: it is g^k only
/// where k is even or g is positive, and a g without a known sign has no root here.
std::optional<ex> monomial_root(const ex& q)
{
    const ex f = q.numer_denom();
    ex result = 1;
    for (int part = 0; part < 2; ++part) {
        ex r = 1;
        const ex side = GiNaC::factor(f.op(static_cast<std::size_t>(part)));
        const auto one = [&r](const ex& g) {
            if (is_a<numeric>(g)) {
                const ex s = GiNaC::sqrt(g);
                if (!is_a<numeric>(s) || !ex_to<numeric>(s).is_rational()) return false;
                r *= s;
                return true;
            }
            if (g.is_equal(GiNaC::Pi)) return false;
            if (is_a<GiNaC::power>(g) && is_a<numeric>(g.op(1)) && (ex_to<numeric>(g.op(1)) / 2).is_integer()) {
                const bool fourth = (ex_to<numeric>(g.op(1)) / 4).is_integer();
                const ex negative = GiNaC::expand(-g.op(0));
                if (!fourth && !is_positive(g.op(0)) && !is_positive(negative)) return false;
                r *= GiNaC::pow(fourth || is_positive(g.op(0)) ? g.op(0) : negative, g.op(1) / 2);
                return true;
            }
            return false;
        };
        if (is_a<GiNaC::mul>(side)) {
            for (const ex& g : side)
                if (!one(g)) return std::nullopt;
        } else if (!one(side)) {
            return std::nullopt;
        }
        result = part == 0 ? result * r : result / r;
    }
    return result;
}

} // namespace

ex Ring::root(const std::string& name, const ex& square)
{
    const ex t = sym(name);
    relations_.push_back({t, rewrite(square)});
    return t;
}

std::pair<ex, ex> Ring::angle(const std::string& name, const ex& w)
{
    const ex s = sym("sin_" + name), c = sym("cos_" + name);
    angles_.push_back({w, s, c});
    relations_.push_back({c, 1 - s * s});
    return {s, c};
}

bool Ring::is_angle_relation(const Relation& r) const
{
    for (const Angle& a : angles_)
        if (a.c.is_equal(r.t)) return true;
    return false;
}

ex Ring::rewrite(const ex& e) const
{
    return bottom_up(e, [this](const ex& x) -> ex {
        if (is_a<GiNaC::function>(x)) {
            const std::string f = ex_to<GiNaC::function>(x).get_name();
            for (const Angle& a : angles_) {
                const ex times = GiNaC::normal(x.op(0) / a.w);
                if (f == "sin" && times.is_equal(1)) return a.s;
                if (f == "cos" && times.is_equal(1)) return a.c;
                if (f == "sin" && times.is_equal(2)) return 2 * a.s * a.c;
                if (f == "cos" && times.is_equal(2)) return 1 - 2 * a.s * a.s;
            }
        }
        if (is_a<GiNaC::power>(x) && is_a<numeric>(x.op(1)) && ex_to<numeric>(x.op(1) * 2).is_integer() &&
            !ex_to<numeric>(x.op(1)).is_integer()) {
            for (const Relation& r : relations_) {
                if (is_angle_relation(r)) continue;
                const ex q = GiNaC::normal(x.op(0) / r.square);
                if (const auto c = monomial_root(q)) return GiNaC::pow(*c * r.t, x.op(1) * 2);
            }
        }
        return x;
    });
}

bool Ring::zero(const ex& e) const
{
    ex n = GiNaC::numer(GiNaC::normal(rewrite(e)));
    for (auto r = relations_.rbegin(); r != relations_.rend(); ++r) {
        n = GiNaC::expand(n);
        if (!n.has(r->t)) continue;
        // t^2k -> square^k, t^(2k+1) -> square^k t: division with remainder by t^2 - square.
        ex reduced = 0;
        for (int k = n.ldegree(r->t); k <= n.degree(r->t); ++k)
            reduced += n.coeff(r->t, k) * GiNaC::pow(r->square, k / 2) * (k % 2 ? r->t : ex(1));
        n = GiNaC::numer(GiNaC::normal(reduced));
    }
    return GiNaC::expand(GiNaC::normal(n)).is_zero();
}

ex Ring::concrete(const ex& e) const
{
    ex out = e;
    for (auto r = relations_.rbegin(); r != relations_.rend(); ++r)
        if (!is_angle_relation(*r)) out = out.subs(r->t == GiNaC::sqrt(r->square));
    for (const Angle& a : angles_) out = out.subs(GiNaC::lst{a.s == GiNaC::sin(a.w), a.c == GiNaC::cos(a.w)});
    return out;
}

Check identity(const ex& left, const ex& right, const Points& points, const Ring& ring)
{
    if ((left - right).is_zero() || ring.zero(left - right)) {
        const Check numbers = compare_at(ring.concrete(left), ring.concrete(right), points);
        if (numbers.verdict == Verdict::refuted)
            throw std::logic_error("normal form and balls contradict each other: " + numbers.detail);
        if (!evaluates_at(ring.concrete(left), ring.concrete(right), points)) return numbers;
        return {Verdict::proved, "both sides have the same normal form"};
    }
    return compare_at(ring.concrete(left), ring.concrete(right), points);
}

namespace {

/// The symbol that stands for the logarithm of e, the same for equal normal forms.
ex log_symbol(const ex& e)
{
    static std::vector<std::pair<ex, ex>> known;
    for (const auto& [of, symbol] : known) // up to sign: GiNaC writes 1/(1 - nu^2) as -1/(nu^2 - 1)
        if (of.is_equal(e) || GiNaC::normal(GiNaC::expand(of - e)).is_zero() || GiNaC::normal(GiNaC::expand(of + e)).is_zero())
            return symbol;
    known.emplace_back(e, GiNaC::realsymbol("log(" + str(e) + ")"));
    return known.back().second;
}

ex log_of_integer(numeric n)
{
    // divisors that are tried: what has none of them keeps a logarithm of its own, which proves less and nothing false
    const numeric largest = 1 << 16;
    ex sum = 0;
    for (numeric p = 2; p * p <= n && p < largest; p = p + 1)
        while (GiNaC::irem(n, p).is_zero()) {
            sum += log_symbol(p);
            n = GiNaC::iquo(n, p);
        }
    return n.is_equal(1) ? sum : ex(sum + log_symbol(n));
}

/// A root hides the sign of what was raised to an even power under it, and the logarithm with it: ((x - 1)^2)^(1/2) is not x - 1.
/// So under a power that is not an integer at most one factor may lack a known sign, and that to an odd power:
/// the root being real then says it is positive.
bool hides_a_sign(const ex& e)
{
    if (is_a<GiNaC::power>(e) && !(is_a<numeric>(e.op(1)) && ex_to<numeric>(e.op(1)).is_integer())) {
        int unknown = 0;
        const auto look = [&unknown](const ex& factor) {
            if (is_positive(factor) || is_a<numeric>(factor)) return; // GiNaC writes 1 - nu^2 as -(nu^2 - 1)
            const bool power = is_a<GiNaC::power>(factor), number = power && is_a<numeric>(factor.op(1));
            if (number && !ex_to<numeric>(factor.op(1)).is_integer()) return; // a root is not negative
            const bool odd = !power || (number && ex_to<numeric>(factor.op(1)).is_odd()); // a symbol may stand for an even number
            unknown += odd ? 1 : 2;
        };
        if (is_a<GiNaC::mul>(e.op(0)))
            for (const ex& factor : e.op(0)) look(factor);
        else
            look(e.op(0));
        if (unknown > 1) return true;
    }
    for (std::size_t i = 0; i < e.nops(); ++i)
        if (hides_a_sign(e.op(i))) return true;
    return false;
}

ex log_of(const ex& e)
{
    if (is_a<GiNaC::mul>(e)) {
        ex sum = 0;
        for (const ex& f : e) sum += log_of(f);
        return sum;
    }
    if (is_a<GiNaC::power>(e)) return e.op(1) * log_of(e.op(0));
    if (is_a<numeric>(e)) {
        const numeric& n = ex_to<numeric>(e);
        if (!n.is_rational() || n.is_zero()) throw std::invalid_argument("logarithm of " + str(e));
        return log_of_integer(GiNaC::abs(n.numer())) - log_of_integer(n.denom());
    }
    if (is_a<GiNaC::function>(e)) {
        ex argument = GiNaC::normal(GiNaC::expand(e.op(0)));
        if (ex_to<GiNaC::function>(e).get_name() == "tgamma") return log_symbol(GiNaC::tgamma(argument));
        return log_symbol(e);
    }
    return log_symbol(e);
}

bool is_whole(const ex& e) { return is_a<numeric>(e) && ex_to<numeric>(e).is_integer(); }

/// The symbol that stands for the sign of e, of which -e has another.
ex sign_symbol(const ex& e)
{
    static std::vector<std::pair<ex, ex>> known;
    for (const auto& [of, symbol] : known)
        if (GiNaC::normal(GiNaC::expand(of - e)).is_zero()) return symbol;
    known.emplace_back(e, GiNaC::realsymbol("sign(" + str(e) + ")"));
    return known.back().second;
}

ex signs_of(const ex& e);

/// Of what is raised to a power that is no whole number. Its numbers give their sign to the factor without a known one, of which there is
/// one at most (hides_a_sign): 1 - nu^2 is found again in -(nu^2 - 1).
ex signs_of_base(const ex& base)
{
    ex sum = 0, sign = 1, unknown = 1, power = 1;
    const auto take = [&](const ex& f) {
        const bool is_power = is_a<GiNaC::power>(f);
        if (is_a<numeric>(f)) sign *= ex_to<numeric>(f).is_negative() ? -1 : 1;
        else if (is_power && !is_whole(f.op(1))) sum += signs_of(f);
        else if (!is_positive(f)) {
            unknown *= is_power ? f.op(0) : f;
            power = is_power ? f.op(1) : ex(1);
        }
    };
    if (is_a<GiNaC::mul>(base))
        for (const ex& f : base) take(f);
    else
        take(base);
    const ex alone = sign * unknown;
    return alone.is_equal(1) ? sum : ex(sum + power * sign_symbol(alone));
}

/// log_of leaves signs out, which is right under whole powers alone: (-x)^n is not x^n. This is the sum of the other powers' signs.
ex signs_of(const ex& e)
{
    ex sum = 0;
    if (is_a<GiNaC::mul>(e))
        for (const ex& f : e) sum += signs_of(f);
    if (is_a<GiNaC::power>(e)) sum = e.op(1) * (is_whole(e.op(1)) ? signs_of(e.op(0)) : signs_of_base(e.op(0)));
    return sum;
}

/// Both sides have each sign equally often, but for a whole number of times, which their signs at a point tell.
bool have_the_same_signs(const ex& left, const ex& right)
{
    const ex off = GiNaC::expand(GiNaC::normal(GiNaC::expand(signs_of(left) - signs_of(right))));
    const auto is_right = [](const ex& term) {
        int symbols = 0;
        const auto look = [&symbols](const ex& f) { symbols += is_a<GiNaC::symbol>(f) ? 1 : is_whole(f) ? 0 : 2; };
        if (is_a<GiNaC::mul>(term))
            for (const ex& f : term) look(f);
        else
            look(term);
        return symbols < 2; // of which one is the sign
    };
    if (!is_a<GiNaC::add>(off)) return is_right(off);
    for (const ex& term : off)
        if (!is_right(term)) return false;
    return true;
}

} // namespace

ex log_form(const ex& e) { return GiNaC::normal(GiNaC::expand(log_of(e))); }

Check power_identity(const ex& left, const ex& right, const Points& points)
{
    // The logarithms are of absolute values; the sign is that of one point, since no factor vanishes.
    const Check numbers = compare_at(left, right, points);
    if (numbers.verdict == Verdict::refuted || points.empty() || !evaluates_at(left, right, points)) return numbers;
    if (hides_a_sign(left) || hides_a_sign(right))
        return {Verdict::undecided, "the root of an even power of something without a known sign"};
    if (have_the_same_signs(left, right) && GiNaC::normal(GiNaC::expand(log_form(left) - log_form(right))).is_zero())
        return {Verdict::proved, "the logarithms of both sides have the same normal form"};
    return numbers;
}

Check positive(const ex& e, const Points& points)
{
    const ex parts = GiNaC::normal(e).numer_denom();
    bool all = true;
    for (std::size_t i = 0; i < 2; ++i) {
        const ex side = GiNaC::expand(parts.op(i));
        const auto is_positive = [](const ex& term) {
            // A term of a polynomial in positive symbols is positive if its numerical coefficient is.
            ex c = 1;
            if (is_a<GiNaC::mul>(term)) {
                for (const ex& f : term)
                    if (is_a<numeric>(f)) c = f;
                    else if (!f.info(GiNaC::info_flags::positive)) return false;
            } else if (is_a<numeric>(term)) {
                c = term;
            } else if (!term.info(GiNaC::info_flags::positive)) {
                return false;
            }
            return ex_to<numeric>(c).is_positive();
        };
        if (is_a<GiNaC::add>(side)) {
            for (const ex& term : side) all = all && is_positive(term);
        } else {
            all = all && is_positive(side);
        }
    }
    if (all) return {Verdict::proved, "a quotient of polynomials with positive coefficients in positive quantities"};
    for (const Point& p : points)
        if (!possibly(less(Ball(0), evaluate(e, p)))) return {Verdict::refuted, "at " + str(p) + " it is " + evaluate(e, p).to_string(8)};
    return {Verdict::undecided, "coefficients of both signs"};
}

Check limit_at_zero(const ex& e, const ex& x, const ex& value, const Points& points)
{
    const ex series = GiNaC::series_to_poly(e.series(x == 0, 2));
    if (series.ldegree(x) < 0) return {Verdict::refuted, "it grows without bound"};
    const ex leading = GiNaC::normal(series.coeff(x, 0));
    if (GiNaC::normal(GiNaC::expand(leading - value)).is_zero()) return {Verdict::proved, "leading term of the series"};
    const Check c = compare_at(leading, value, points);
    return {c.verdict, "the leading term of the series: " + c.detail};
}

Check condition_says(const Print& p, const std::string& field, const ex& left, const std::string& relation, const ex& right,
                     const Points& points)
{
    const std::string& text = p.text(field);
    std::string signs;
    for (const char c : text)
        if (c == '<' || c == '>' || c == '=') signs += c;
    const std::vector<ex> sides = p.sides(field);
    const bool turned = signs == (relation == ">" ? "<" : ">"); // b < a says a > b
    if (sides.size() != 2 || (signs != relation && !turned) || text.find(" or ") != std::string::npos)
        return {Verdict::refuted, "printed " + text};
    const Check one = identity(sides.at(turned ? 1 : 0), left, points);
    return one.verdict == Verdict::proved ? identity(sides.at(turned ? 0 : 1), right, points) : one;
}

Check exactly(bool holds, const std::string& detail)
{
    return {holds ? Verdict::proved : Verdict::refuted, detail};
}

} // namespace touchstone::proofs
