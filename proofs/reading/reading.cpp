// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/reading/reading.hpp"

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/reading/whole.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace touchstone::proofs {

namespace {

class Unreadable : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class Holds { yes, no, no_value, undecided };

/// |l/r - 1| below 2^-bits, or both zero.
bool agree(const Ball& l, const Ball& r, long bits)
{
    if (l.contains_zero() && r.contains_zero()) return true;
    return certainly(less(abs(l / r - 1), ScalarTraits<Ball>::power_of_two(-bits)));
}
constexpr long limit_bits = 25;     ///< what "tends to" must reach where n is large
constexpr long equality_bits = 60;  ///< two enclosures that agree this far are taken for equal when < is asked
constexpr long quadrature_bits = 6; ///< the integrals over xi are enclosed this far at least

/// Overlapping enclosures that are much wider than the working precision makes them say nothing of equality: sin of a huge number is
/// enclosed by [-1, 1], which has 0 in it, and is not 0 for that.
bool narrow_and_overlapping(const Ball& l, const Ball& r)
{
    const long bits = static_cast<long>(WorkingPrecision::bits() / 2);
    if (!l.contains_zero() || !r.contains_zero()) return l.overlaps(r) && agree(l, r, bits);
    const Ball small = ScalarTraits<Ball>::power_of_two(-bits);
    return certainly(less(abs(l), small)) && certainly(less(abs(r), small));
}

/// Where nothing is approached: what the enclosures prove, and equality of sides that cannot be told apart.
Holds relation_holds_strictly(const std::string& relation, const Ball& l, const Ball& r)
{
    if (relation == "=" || relation == "==")
        return !l.overlaps(r) ? Holds::no : narrow_and_overlapping(l, r) ? Holds::yes : Holds::undecided;
    if (narrow_and_overlapping(l, r)) return relation.size() == 2 ? Holds::yes : Holds::no;
    const bool less_is_asked = relation[0] == '<', may_be_equal = relation.size() == 2;
    const Ball &low = less_is_asked ? l : r, &high = less_is_asked ? r : l;
    const Truth is_less = less(low, high), is_more = less(high, low);
    if (certainly(is_less) || (may_be_equal && !possibly(is_more))) return Holds::yes;
    return certainly(is_more) || (!may_be_equal && !possibly(is_less)) ? Holds::no : Holds::undecided;
}

/// \param agreeing_is_equal see Situation
Holds relation_holds(const std::string& relation, const Ball& l, const Ball& r, bool agreeing_is_equal)
{
    if (!l.is_finite() || !r.is_finite()) return Holds::no_value;
    if (!agreeing_is_equal && relation != "~" && relation != "->") {
        static const std::set<std::string> known{"=", "==", "<", "<=", ">", ">="};
        if (!known.count(relation)) throw Unreadable("the relation " + relation);
        return relation_holds_strictly(relation, l, r);
    }
    if (relation == "=" || relation == "==") {
        if (!l.overlaps(r)) return Holds::no;
        return agree(l, r, quadrature_bits) ? Holds::yes : Holds::undecided;
    }
    if (relation == "~" || relation == "->") return agree(l, r, limit_bits) ? Holds::yes : Holds::no;
    const bool less_is_asked = relation == "<" || relation == "<=";
    if (!less_is_asked && relation != ">" && relation != ">=") throw Unreadable("the relation " + relation);
    const Truth t = less_is_asked ? less(l, r) : less(r, l);
    if (agree(l, r, equality_bits)) return relation.size() == 2 ? Holds::yes : Holds::no;
    return certainly(t) ? Holds::yes : possibly(t) ? Holds::undecided : Holds::no;
}

/// "0 < p < 2*sqrt(pstar*pbar)", or "gamma^n odd", or several of these joined by "or".
struct Condition {
    struct Chain {
        std::vector<ex> sides;
        std::vector<std::string> relations;
        std::string property; ///< of a single side: odd, even or integer
    };
    std::vector<Chain> alternatives;

    static Condition parse(const std::string& text)
    {
        Condition c;
        std::size_t from = 0;
        while (true) {
            const std::size_t cut = text.find(" or ", from);
            c.alternatives.push_back(chain(text.substr(from, cut == std::string::npos ? cut : cut - from)));
            if (cut == std::string::npos) return c;
            from = cut + 4;
        }
    }

private:
    static Chain chain(const std::string& text)
    {
        Chain c;
        for (const std::string property : {"odd", "even", "integer"})
            if (text.ends_with(" " + property)) {
                c.sides.push_back(read(text.substr(0, text.size() - property.size())));
                c.property = property;
                return c;
            }
        std::string side;
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] != '<' && text[i] != '>') {
                side += text[i];
                continue;
            }
            c.sides.push_back(read(side));
            side.clear();
            const bool equal = i + 1 < text.size() && text[i + 1] == '=';
            c.relations.push_back(std::string(1, text[i]) + (equal ? "=" : ""));
            i += equal ? 1 : 0;
        }
        c.sides.push_back(read(side));
        return c;
    }
};

/// Does a function in e surely get what it has no value at? An enclosure that only reaches out of a domain does not say so.
bool surely_no_value(const ex& e, const std::map<std::string, Ball>& values)
{
    for (std::size_t i = 0; i < e.nops(); ++i)
        if (surely_no_value(e.op(i), values)) return true;
    const bool power = GiNaC::is_a<GiNaC::power>(e), function = GiNaC::is_a<GiNaC::function>(e);
    if (!power && !function) return false;
    const Ball x = evaluate(e.op(0), values), zero(0);
    const bool is_zero = x.is_exact() && x.contains_zero();
    if (power) {
        if (!GiNaC::is_a<GiNaC::numeric>(e.op(1))) return false;
        const GiNaC::numeric exponent = GiNaC::ex_to<GiNaC::numeric>(e.op(1));
        return (!exponent.is_integer() && certainly(less(x, zero))) || (exponent.is_negative() && is_zero);
    }
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if (name == "log") return is_zero || certainly(less(x, zero));
    return (name == "asin" || name == "acos") && certainly(less(Ball(1), abs(x)));
}

class Reader {
public:
    Reader(const Print& print, const Situation& s) : print_(print), situation_(s), values_(s.value) {}

    Ball value(const ex& e)
    {
        for (const ex& symbol : symbols_of(e)) need(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
        return evaluate(e, values_);
    }
    /// Whether it holds between the two. What has no enclosure may have a value all the same.
    Holds relation(const std::string& is, const ex& left, const Ball& l, const ex& right, const Ball& r) const
    {
        const Holds holds = relation_holds(is, l, r, situation_.agreeing_is_equal);
        const bool surely = situation_.agreeing_is_equal || surely_no_value(left, values_) || surely_no_value(right, values_);
        return holds == Holds::no_value && !surely ? Holds::undecided : holds;
    }
    Holds condition(const Condition& c)
    {
        Holds any = Holds::no;
        for (const auto& chain : c.alternatives) {
            Holds all = chain.property.empty() || has_property(chain.property, value(chain.sides[0])) ? Holds::yes : Holds::no;
            for (std::size_t i = 0; i < chain.relations.size(); ++i) {
                const ex &left = chain.sides[i], &right = chain.sides[i + 1];
                const Holds one = relation(chain.relations[i], left, value(left), right, value(right));
                if (one == Holds::no || (one != Holds::yes && all == Holds::yes)) all = one; // one that fails is enough
            }
            if (all == Holds::yes) return Holds::yes;
            if (all != Holds::no) any = all;
        }
        return any;
    }

private:
    static bool has_property(const std::string& property, const Ball& b)
    {
        for (long k = -1000; k <= 1000; ++k) // the situations' numbers are small
            if (b.contains(Rational(k)) && certainly(less(abs(b - k), ScalarTraits<Ball>::power_of_two(-equality_bits))))
                return property == "integer" || (k % 2 != 0) == (property == "odd");
        return false;
    }
    static std::vector<ex> symbols_of(const ex& e)
    {
        if (GiNaC::is_a<GiNaC::symbol>(e)) return {e};
        std::vector<ex> all;
        for (std::size_t i = 0; i < e.nops(); ++i)
            for (const ex& s : symbols_of(e.op(i))) all.push_back(s);
        return all;
    }
    const std::string& field(const std::string& piece, const char* name) const { return print_.text(piece + "." + name); }

    void need(const std::string& name)
    {
        if (values_.count(name)) return;
        if (!print_.has(name + ".kind")) throw Unreadable(name + " means nothing in (" + print_.id + ")");
        values_.emplace(name, piece(name, field(name, "kind")));
    }
    Ball piece(const std::string& name, const std::string& kind)
    {
        if (kind == "sum" || kind == "product") return series(name, kind == "sum");
        if (kind == "integral") return integral(name);
        if (kind == "function") {
            const auto f = situation_.function.find(field(name, "of"));
            if (f == situation_.function.end()) throw Unreadable("no function " + field(name, "of"));
            return f->second(value(read(field(name, "argument"))));
        }
        if (kind == "derivative") {
            const auto d = situation_.derivative.find({field(name, "of"), field(name, "by")});
            if (d == situation_.derivative.end())
                throw Unreadable("the derivative of " + field(name, "of") + " by " + field(name, "by") + " is not what is meant");
            return d->second;
        }
        if (kind == "limit") {
            if (field(name, "variable") != "n" || field(name, "to") != "infinity")
                throw Unreadable("a limit as " + field(name, "variable") + " tends to " + field(name, "to"));
            const auto limit = situation_.limit.find(field(name, "of"));
            if (limit == situation_.limit.end()) throw Unreadable("the limit of " + field(name, "of") + " is not what is meant");
            return limit->second;
        }
        throw Unreadable("a piece of the kind " + kind);
    }
    long whole_number(const std::string& text)
    {
        if (text == "infinity") return situation_.last_term;
        const Ball v = value(read(text));
        const WorkingPrecision precision(64);
        for (long k = -50; k <= 200; ++k) // terms and factors are counted by small numbers
            if (v.contains(Rational(k)) && v.radius_bound() < 0.25) return k;
        throw Unreadable("a sum to " + text);
    }
    Ball series(const std::string& name, bool sum)
    {
        const std::string& index = field(name, "index");
        const long from = whole_number(field(name, "from")), to = whole_number(field(name, "to"));
        const ex term = read(field(name, "term"));
        const auto outer = values_.find(index);
        const std::optional<Ball> kept = outer == values_.end() ? std::nullopt : std::optional(outer->second);
        Ball all(sum ? 0 : 1);
        for (long k = from; k <= to; ++k) {
            values_[index] = Ball(k);
            if (index == "n")
                for (const auto& [symbol, at] : situation_.of_index) values_[symbol] = at(k);
            if (sum) all += value(term);
            else all *= value(term);
        }
        if (kept) values_[index] = *kept;
        else values_.erase(index);
        for (const auto& [symbol, at] : situation_.of_index) values_.erase(symbol);
        return all;
    }
    Ball integral(const std::string& name)
    {
        const std::string& v = field(name, "variable");
        if (v == situation_.pointwise) return pointwise(name, v);
        return by_pieces(name, v);
    }
    /// The integrand where the variable lies between the limits, with the sign of the direction.
    Ball pointwise(const std::string& name, const std::string& variable)
    {
        const Ball at = values_.at(variable);
        const auto above = [&](const char* end) {
            const std::string& text = field(name, end);
            if (text == "infinity") return false;
            const Truth t = less(value(read(text)), at);
            if (!certainly(t) && possibly(t)) throw Unreadable("the limit " + text + " where it is not decided");
            return certainly(t);
        };
        const bool from = above("from"), to = above("to");
        if (from == to) return Ball(0);
        const Ball f = value(read(field(name, "integrand")));
        return from ? f : -f;
    }
    /// Enclosures on pieces that shrink towards both ends, where the integrand may have no finite enclosure; what is left, 2^-40 of
    /// the range at each end, is charged as if the integrand were below 2^20 there.
    Ball by_pieces(const std::string& name, const std::string& variable)
    {
        const Ball a = value(read(field(name, "from"))), b = value(read(field(name, "to")));
        const ex integrand = read(field(name, "integrand"));
        for (const ex& s : symbols_of(integrand))
            if (GiNaC::ex_to<GiNaC::symbol>(s).get_name() != variable) need(GiNaC::ex_to<GiNaC::symbol>(s).get_name());
        const auto outer = values_.find(variable);
        const std::optional<Ball> kept = outer == values_.end() ? std::nullopt : std::optional(outer->second);
        const WorkingPrecision precision(64);
        const Ball middle = (a + b) / 2, half = (b - a) / 2;
        Ball all(0);
        const int parts = 8, last = 40; // pieces per octave of the distance to the end
        for (const int side : {-1, 1}) {
            Ball outside(1);
            for (int octave = 0; octave < last; ++octave)
                for (int k = 0; k < parts; ++k) {
                    const Ball inner = ScalarTraits<Ball>::power_of_two(-octave) * Ball(Rational(2 * parts - k - 1, 2 * parts));
                    values_[variable] = middle + half * side * hull(1 - outside, 1 - inner);
                    all += evaluate(integrand, values_) * half * (outside - inner);
                    outside = inner;
                }
            all += half * hull(Ball(-1), Ball(1)) * ScalarTraits<Ball>::power_of_two(20 - last);
        }
        if (kept) values_[variable] = *kept;
        else values_.erase(variable);
        return all;
    }

    const Print& print_;
    const Situation& situation_;
    std::map<std::string, Ball> values_;
};

struct Part {
    ex left, right;
    std::string relation;
    std::optional<Condition> condition;
    bool digits_only = false; ///< the right side is a number printed with its decimals
};

std::vector<Part> parts_of(const Print& p)
{
    std::vector<Part> all;
    for (std::size_t i = 0; i < p.parts(); ++i) {
        const std::string n = std::to_string(i) + ".";
        Part part{p(n + "lhs"), p(n + "rhs"), p.text(n + "relation"), {}};
        if (p.has(n + "condition")) part.condition = Condition::parse(p.text(n + "condition"));
        if (p.has(n + "digits")) {
            std::string digits = p.text(n + "digits");
            if (digits.ends_with("...")) digits.resize(digits.size() - 3);
            if (digits != p.text(n + "rhs")) throw Unreadable("the number is " + p.text(n + "rhs") + ", its digits are " + digits);
            if (part.relation != "=") throw Unreadable("digits after " + part.relation);
            if (i == 0 || p.text(n + "lhs") != p.text(std::to_string(i - 1) + ".rhs")) throw Unreadable("what the digits are of");
            part.digits_only = true;
        }
        all.push_back(std::move(part));
    }
    return all;
}

std::string where(const Situation& s, const Part& part)
{
    std::string text;
    for (const auto& [name, ball] : s.value)
        if (part.left.has(sym(name)) || part.right.has(sym(name))) {
            const std::string shown = ball.to_string(5);
            text += (text.empty() ? "" : ", ") + name + " = " + (shown[0] == '[' ? shown.substr(1, shown.find(' ') - 1) : shown);
        }
    return text;
}

/// What has been met on the way through the situations.
struct Seen {
    std::vector<bool> reached; ///< by part: the two sides were equal once
    std::vector<int> looked;   ///< by part: situations in which the relation was asked, and an answer came
    /// By part: where balls could not tell whether it, or its condition, holds; empty if they always could.
    std::vector<std::string> undecided;
    bool stated_held = false;  ///< all stated parts, in one situation
    std::map<std::pair<std::size_t, std::size_t>, std::pair<bool, std::string>>
        outside; ///< by group and part: did it fail outside its condition?
};

/// What one situation says against the print, or nothing.
std::optional<std::string> objection(const Print& print, const std::vector<Part>& parts, const Meaning& m, const Situation& s, Seen& seen)
{
    std::vector<bool>& reached = seen.reached;
    std::vector<int>& looked = seen.looked;
    Reader reader(print, s);
    bool stated_hold = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        if (part.digits_only) {
            ++looked[i];
            reached[i] = true;
            continue; // the judge's business
        }
        if ((part.relation == "~" || part.relation == "->") && !s.large_n) continue;
        const bool stated = m.stated.count(i) != 0;
        const Holds condition = part.condition ? reader.condition(*part.condition) : Holds::yes;
        const auto undecided = [&](const char* what) {
            seen.undecided[i] = "at " + where(s, part) + " balls do not decide " + what + std::to_string(i);
        };
        if (condition == Holds::undecided) {
            undecided("the printed condition of part ");
            continue;
        }
        if (m.may_say_less && condition != Holds::yes) continue;
        if (s.at_equality && (!part.condition || condition != Holds::yes)) continue;
        const Ball l = reader.value(part.left), r = reader.value(part.right);
        const Holds holds = reader.relation(part.relation, part.left, l, part.right, r);
        if (l.is_finite() && r.is_finite() && agree(l, r, equality_bits)) reached[i] = true;
        if (stated) {
            if (holds == Holds::undecided) {
                undecided("part ");
                return std::nullopt;
            }
            stated_hold = stated_hold && holds == Holds::yes;
            ++looked[i];
            continue;
        }
        if (holds == Holds::undecided) {
            undecided("part ");
            continue;
        }
        const std::string sides = "the left side is " + l.to_string(6) + ", the right side " + r.to_string(6);
        if (condition == Holds::yes) {
            ++looked[i];
            if (holds != Holds::yes) return "at " + where(s, part) + " " + sides + ", printed " + part.relation;
        } else if (!s.group) {
            if (holds == Holds::yes) return "at " + where(s, part) + ", outside the printed condition, it holds too: " + sides;
        } else {
            auto& outside = seen.outside[{*s.group, i}];
            outside.first = outside.first || holds != Holds::yes;
            outside.second = "at " + where(s, part) + ", outside the printed condition, it holds too";
        }
    }
    seen.stated_held = seen.stated_held || stated_hold;
    if (s.wanted && stated_hold != *s.wanted && (stated_hold || !m.one_way))
        return "at " + where(s, parts[*m.stated.begin()]) + " the printed inequality is " + (stated_hold ? "true" : "false") +
               ", what it stands for is " + (*s.wanted ? "true" : "false");
    return std::nullopt;
}

/// A part with the same on both sides, or that repeats another one; or nothing.
std::optional<std::string> says_nothing(const Print& p, const std::vector<Part>& parts, bool as_typed)
{
    const auto typed = [&](std::size_t i, const char* side) {
        std::string text = p.text(std::to_string(i) + "." + side);
        std::erase(text, ' ');
        return text;
    };
    const auto whole = [&](std::size_t i) { return typed(i, "lhs") + typed(i, "relation") + typed(i, "rhs"); };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& a = parts[i];
        if (as_typed ? a.relation == "=" && typed(i, "lhs") == typed(i, "rhs") : a.left.is_equal(a.right))
            return "part " + std::to_string(i) + " has the same on both sides: it says nothing";
        for (std::size_t j = 0; j < i; ++j)
            if (as_typed ? whole(i) == whole(j) : a.left.is_equal(parts[j].left) && a.right.is_equal(parts[j].right))
                return "part " + std::to_string(i) + " repeats part " + std::to_string(j);
    }
    return std::nullopt;
}

} // namespace

const Meaning* meaning(const std::string& id)
{
    static const std::map<std::string, Meaning> all = [] {
        std::map<std::string, Meaning> m;
        add_meanings_of_sections_2_3(m);
        add_meanings_of_sections_5_6(m);
        add_meanings_of_section_7(m);
        add_meanings_of_sections_8_9(m);
        add_meanings_of_sentences(m);
        add_meanings_beyond(m);
        return m;
    }();
    const auto found = all.find(id);
    return found == all.end() ? nullptr : &found->second;
}

std::optional<Check> read_whole(const Print& print)
{
    const Meaning* m = meaning(print.id);
    if (m == nullptr) return std::nullopt;
    return read_whole_as(print, *m);
}

Check read_whole_as(const Print& print, const Meaning& says)
{
    const Meaning* m = &says;
    constexpr slong usual_bits = 192; // unless the caller looks closer
    const WorkingPrecision precision(std::max(usual_bits, WorkingPrecision::bits()));
    try {
        const std::vector<Part> parts = parts_of(print);
        if (const auto nothing = says_nothing(print, parts, m->may_say_less)) return Check{Verdict::refuted, *nothing};
        Seen seen{
            std::vector<bool>(parts.size(), false), std::vector<int>(parts.size(), 0), std::vector<std::string>(parts.size()), false, {}};
        for (const Situation& s : m->situations)
            if (const auto found = objection(print, parts, *m, s, seen)) return Check{Verdict::refuted, *found};
        if (m->one_way && !seen.stated_held) return Check{Verdict::refuted, "what is printed holds in no situation"};
        for (const auto& [key, outside] : seen.outside)
            if (!outside.first) return Check{Verdict::refuted, outside.second};
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (m->every_situation_decides && !seen.undecided[i].empty()) return Check{Verdict::undecided, seen.undecided[i]};
            if (seen.looked[i] == 0)
                return Check{m->may_say_less ? Verdict::undecided : Verdict::refuted,
                             "the printed condition of part " + std::to_string(i) + " holds in no situation"};
            if (m->bounds_are_reached && !seen.reached[i])
                return Check{Verdict::refuted, "the printed bound is not reached: it is too wide"};
        }
        return Check{Verdict::verified,
                     "every field of the print read in " + std::to_string(m->situations.size()) + " situations in balls"};
    } catch (const Unreadable& e) {
        return Check{Verdict::refuted, std::string("cannot be read: ") + e.what()};
    } catch (const std::exception& e) { // GiNaC's parser, a division by zero, an operand outside a function's domain
        return Check{Verdict::refuted, std::string("cannot be read: ") + e.what()};
    }
}

} // namespace touchstone::proofs
