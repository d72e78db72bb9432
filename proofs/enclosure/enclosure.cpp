// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/enclosure/enclosure.hpp"

#include <deque>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace touchstone::proofs {

Point point(const std::string& text)
{
    Point p;
    std::istringstream in(text);
    for (std::string item; in >> item;) {
        const std::size_t eq = item.find('=');
        const auto value = eq == std::string::npos ? std::nullopt : parse_rational(item.substr(eq + 1));
        if (!value) throw std::invalid_argument("not a point: " + item);
        p[item.substr(0, eq)] = *value;
    }
    return p;
}

std::string str(const Point& p)
{
    std::string s;
    for (const auto& [name, value] : p) s += (s.empty() ? "" : ", ") + name + " = " + value.get_str();
    return s;
}

namespace {

Rational rational_of(const GiNaC::numeric& n)
{
    std::ostringstream out;
    out << n;
    Rational r(out.str());
    r.canonicalize();
    return r;
}

Ball integer_power(const Ball& base, const Rational& e)
{
    Ball r;
    fmpz_t n; // of any length: powers of powers are one power
    fmpz_init(n);
    fmpz_set_mpz(n, mpz_class(abs(e.get_num())).get_mpz_t());
    arb_pow_fmpz(r.get(), base.get(), n, WorkingPrecision::bits());
    fmpz_clear(n);
    return e < 0 ? Ball(1) / r : r;
}

} // namespace

Ball evaluate(const ex& e, const std::map<std::string, Ball>& values)
{
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
        const auto& n = GiNaC::ex_to<GiNaC::numeric>(e);
        if (!n.is_rational()) throw std::invalid_argument("not an exact number");
        return Ball(rational_of(n));
    }
    if (GiNaC::is_a<GiNaC::constant>(e)) {
        Ball r;
        if (e.is_equal(GiNaC::Pi)) return ScalarTraits<Ball>::pi();
        if (!e.is_equal(GiNaC::Euler)) throw std::invalid_argument("unknown constant");
        arb_const_euler(r.get(), WorkingPrecision::bits()); // of derivatives of the Gamma function
        return r;
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
        const auto found = values.find(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
        if (found == values.end()) throw std::invalid_argument("no value for " + GiNaC::ex_to<GiNaC::symbol>(e).get_name());
        return found->second;
    }
    if (GiNaC::is_a<GiNaC::add>(e)) {
        Ball sum(0);
        for (const ex& term : e) sum += evaluate(term, values);
        return sum;
    }
    if (GiNaC::is_a<GiNaC::mul>(e)) {
        Ball product(1);
        for (const ex& factor : e) product *= evaluate(factor, values);
        return product;
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
        const Ball base = evaluate(e.op(0), values);
        if (GiNaC::is_a<GiNaC::numeric>(e.op(1))) {
            const Rational exponent = rational_of(GiNaC::ex_to<GiNaC::numeric>(e.op(1)));
            if (exponent.get_den() == 1) return integer_power(base, exponent);
            if (exponent.get_den() == 2) return integer_power(sqrt(base), Rational(exponent.get_num()));
        }
        return pow(base, evaluate(e.op(1), values));
    }
    if (GiNaC::is_a<GiNaC::function>(e)) {
        const std::string f = GiNaC::ex_to<GiNaC::function>(e).get_name();
        const Ball x = evaluate(e.op(0), values);
        if (f == "sin") return sin(x);
        if (f == "cos") return cos(x);
        if (f == "asin") return asin(x);
        if (f == "acos") return acos(x);
        if (f == "exp") return exp(x);
        if (f == "log") return log(x);
        if (f == "abs") return abs(x);
        if (f == "tgamma") return ScalarTraits<Ball>::gamma(x);
        if (f == "atan2") return atan2(x, evaluate(e.op(1), values));
        if (f == "atan") return atan2(x, Ball(1));
        if (f == "psi") { Ball r; arb_digamma(r.get(), x.get(), WorkingPrecision::bits()); return r; }
        throw std::invalid_argument("unknown function " + f);
    }
    throw std::invalid_argument("cannot evaluate this expression");
}

Ball evaluate(const ex& e, const Point& p)
{
    std::map<std::string, Ball> values;
    for (const auto& [name, value] : p) values.emplace(name, Ball(value));
    return evaluate(e, values);
}

namespace {

/// The values of the symbols that occur.
Point relevant(const Point& p, const ex& left, const ex& right)
{
    Point used;
    for (const auto& [name, value] : p)
        if (left.has(sym(name)) || right.has(sym(name))) used.emplace(name, value);
    return used;
}
std::string at(const Point& p) { return p.empty() ? "" : "at " + str(p) + " "; }

} // namespace

Check compare_at(const ex& left, const ex& right, const Points& points)
{
    std::string nowhere;
    for (const Point& p : points) {
        const Ball l = evaluate(left, p), r = evaluate(right, p);
        // A side without a value is never passed over: the point was given to be looked at.
        if (!l.is_finite() || !r.is_finite())
            nowhere = at(relevant(p, left, right)) + "it is " + l.to_string(8) + " and " + r.to_string(8) + ", not two numbers";
        else if (!l.overlaps(r))
            return {Verdict::refuted, at(relevant(p, left, right)) + "it is " + l.to_string(8) + ", not " + r.to_string(8)};
    }
    if (!nowhere.empty()) return {Verdict::undecided, nowhere};
    return {Verdict::undecided, "not reduced to zero, and no counterexample at the points tried"};
}

bool evaluates_at(const ex& left, const ex& right, const Points& points)
{
    for (const Point& p : points)
        if (!evaluate(left, p).is_finite() || !evaluate(right, p).is_finite()) return false;
    return true;
}

namespace {

/// f at 2/5 of every range, where nothing is symmetric: what tells one function from another that is positive too (recorded.hpp).
std::string value_inside(const BallFunction& f, const std::vector<Range>& box)
{
    std::vector<Ball> inside;
    for (const Range& r : box) inside.push_back(Ball(Rational(r.low + (r.high - r.low) * 2 / 5)));
    return f(inside).to_string(8);
}

Ball middle_of(const Range& r) { return Ball(Rational((r.low + r.high) / 2)); }

std::string in_words(const std::vector<Range>& box)
{
    std::string where;
    for (const auto& r : box) where += (where.empty() ? "" : ", ") + r.symbol + " in [" + r.low.get_str() + ", " + r.high.get_str() + "]";
    return where;
}

/// The two halves of a piece, cut where it is widest against the whole.
std::pair<std::vector<Range>, std::vector<Range>> halves(std::vector<Range> piece, const std::vector<Range>& whole)
{
    std::size_t widest = 0;
    const auto share = [&](std::size_t i) { return Rational((piece[i].high - piece[i].low) / (whole[i].high - whole[i].low)); };
    for (std::size_t i = 1; i < piece.size(); ++i)
        if (share(i) > share(widest)) widest = i;
    const Rational cut = (piece[widest].low + piece[widest].high) / 2;
    std::vector<Range> upper = piece;
    upper[widest].low = cut;
    piece[widest].high = cut;
    return {std::move(piece), std::move(upper)};
}

} // namespace

Check positive_over(const BallFunction& f, const std::vector<Range>& box, int most_pieces, Bound bound)
{
    for (const Range& r : box)
        if (r.high <= r.low) throw std::invalid_argument("an empty range: " + in_words(box));
    std::deque<std::vector<Range>> todo{box};
    int pieces = 0;
    const Ball zero(0);
    while (!todo.empty()) {
        if (++pieces > most_pieces) return {Verdict::undecided, "undecided after " + std::to_string(most_pieces) + " pieces"};
        const std::vector<Range> piece = std::move(todo.front());
        todo.pop_front();
        std::vector<Ball> values, middle;
        for (const Range& r : piece) {
            values.push_back(hull(Ball(r.low), Ball(r.high)));
            middle.push_back(middle_of(r));
        }
        const bool strict = bound == Bound::strict;
        const Ball over_piece = f(values);
        if (strict ? certainly(less(zero, over_piece)) : over_piece.is_finite() && !possibly(less(over_piece, zero))) continue;
        const Ball at_middle = f(middle);
        if (at_middle.is_finite() && (strict ? !possibly(less(zero, at_middle)) : certainly(less(at_middle, zero)))) {
            std::string where;
            for (const Range& r : piece) where += " " + r.symbol + " = " + Rational((r.low + r.high) / 2).get_str();
            return {Verdict::refuted, "at" + where + " it is " + at_middle.to_string(8)};
        }
        auto [left, right] = halves(piece, box);
        todo.push_back(std::move(left));
        todo.push_back(std::move(right));
    }
    return {Verdict::proved,
            "enclosed for " + in_words(box) + " in " + std::to_string(pieces) + " pieces, at 2/5 of it " + value_inside(f, box)};
}

Check positive_on(const ex& e, const std::vector<Range>& box, int most_pieces, Bound bound)
{
    const auto at = [&](const std::vector<Ball>& v) {
        std::map<std::string, Ball> values;
        for (std::size_t i = 0; i < box.size(); ++i) values.emplace(box[i].symbol, v[i]);
        return evaluate(e, values);
    };
    return positive_over(at, box, most_pieces, bound);
}

Check less_than(const Ball& a, const Ball& b, const std::string& what)
{
    const Truth t = less(a, b);
    const std::string numbers = what + ": " + a.to_string(8) + " < " + b.to_string(8);
    if (certainly(t)) return {Verdict::proved, numbers + " in balls"};
    if (!possibly(t)) return {Verdict::refuted, what + ": " + a.to_string(8) + " is not below " + b.to_string(8)};
    return {Verdict::undecided, numbers + " is not decided"};
}

} // namespace touchstone::proofs
