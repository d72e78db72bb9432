// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/sentences/sentences.hpp"

#include "proofs/lemmas/fixed_point.hpp"
#include "proofs/sentences/wording.hpp"
#include "proofs/symbolic/symbolic.hpp"

namespace touchstone::proofs {

Ball G_of_figure_3a() { return pow(Ball(5), Ball(Rational(1, 20))); }

Check the_fixed_point() { return unique_fixed_point(prints().at("5.4")("rhs"), prints().at("5.5")("rhs")); }

Check opposite(Check c)
{
    if (c.verdict == Verdict::proved) c.verdict = Verdict::refuted;
    return c;
}

Check says_less(const Print& p, const std::string& what)
{
    const std::string& relation = p.text("relation");
    return exactly(relation == "<" || relation == "<=", what + ", printed relation " + relation);
}

Check says_greater(const Print& p, const std::string& what)
{
    const std::string& relation = p.text("relation");
    return exactly(relation == ">" || relation == ">=", what + ", printed relation " + relation);
}

Check number_satisfies(const Ball& quantity, const Print& p, const std::string& what)
{
    const std::string& relation = p.text("relation");
    const Ball number = evaluate(p("rhs"), Point{});
    const std::string says = what + " lies in " + between(quantity) + ", printed " + relation + " " + p.text("rhs");
    const bool below = certainly(less(quantity, number)), above = certainly(less(number, quantity));
    if (relation == "=" && (below || above)) return {Verdict::refuted, says};
    if (relation == "<" || relation == "<=") {
        if (below) return {Verdict::proved, says};
        if (above || !possibly(less(quantity, number))) return {Verdict::refuted, says};
    }
    if (relation == ">" || relation == ">=") {
        if (above) return {Verdict::proved, says};
        if (below || !possibly(less(number, quantity))) return {Verdict::refuted, says};
    }
    return {Verdict::undecided, says};
}

Check stated(const Print& p, const ex& exact, const Points& points)
{
    const std::string& relation = p.text("relation");
    const ex said = p("rhs");
    if (relation.empty() || (relation[0] != '<' && relation[0] != '>')) return identity(said, exact, points);
    const ex room = GiNaC::normal((relation[0] == '<' ? said - exact : exact - said).expand());
    if (room.is_zero()) return exactly(relation.size() == 2, "both are the same, printed " + relation);
    return positive(room, points);
}

Check within(const Ball& quantity, const Ball& range)
{
    return exactly(arb_contains(range.get(), quantity.get()) != 0, quantity.to_string(5) + " in " + between(range));
}

Check share_satisfies(const Ball& share, const Print& p, const std::string& what)
{
    const std::string& relation = p.text("relation");
    const ex number = p("rhs");
    if (relation == "<" && !certainly(less(Ball(0), evaluate(number, Point{}))))
        return {Verdict::refuted, "a share is not negative; printed < " + p.text("rhs")};
    if (relation == ">" && !certainly(less(evaluate(number, Point{}), Ball(1))))
        return {Verdict::refuted, "a share is at most one; printed > " + p.text("rhs")};
    return number_satisfies(share, p, what);
}

bool at_most_for_all_G(const ex& bound, const ex& largest)
{
    const ex left = GiNaC::normal((largest - bound).subs(sym("G") == 1 + sym("u")));
    return left.is_zero() || positive(left, {}).verdict == Verdict::proved;
}

std::optional<Ball> positive_bound(const ex& bound, const Point& at)
{
    const Ball b = evaluate(bound, at);
    if (!b.is_finite() || !certainly(less(Ball(0), b))) return std::nullopt;
    return b;
}

Check between_proof_and_counterexample() { return {Verdict::undecided, "no counterexample met below the bound, no proof up to it"}; }

Finding not_computed(const std::string& what)
{
    Finding f;
    f.method = "none";
    f.reason = what;
    return f;
}

std::string between(const Ball& hull)
{
    Ball low, high;
    arb_get_lbound_arf(arb_midref(low.get()), hull.get(), 30);
    arb_get_ubound_arf(arb_midref(high.get()), hull.get(), 30);
    if (certainly(less(abs(low), ScalarTraits<Ball>::power_of_two(-25) * abs(high)))) low = Ball(0); // a radius has thirty bits
    const auto shown = [](const Ball& b) {
        const std::string t = b.to_string(5);
        return t.substr(0, t.find(" ")).substr(t[0] == '[' ? 1 : 0);
    };
    return shown(low) + " to " + shown(high);
}

std::vector<Claim> sentences()
{
    std::vector<Claim> all;
    for (auto* part :
         {&sentences_of_sections_2_5, &sentences_of_sections_6_7, &sentences_of_sections_8_11, &sentences_about_the_text, &figures})
        for (Claim& c : part()) all.push_back(std::move(c));
    return all;
}

} // namespace touchstone::proofs
