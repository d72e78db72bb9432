// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/quantity.hpp"

#include "touchstone/scalar/second_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace touchstone {

Inputs::Inputs(std::map<std::string, Rational> values) : values_(std::move(values))
{
    for (auto& [name, value] : values_) {
        if (value.get_den() == 0) throw std::invalid_argument(name + ": its denominator is 0");
        value.canonicalize();
    }
}

Exact Inputs::G_exact() const
{
    if (has("G")) return Exact(real("G"));
    return Exact(real("gamma")).power(real("D") - 1);
}

Ball Inputs::G_ball() const
{
    if (has("G")) return ball("G");
    return pow(ball("gamma"), widened(Ball(Rational(real("D") - 1)), "D"));
}

Ball Inputs::ball(const std::string& key) const { return widened(Ball(real(key)), key); }

Ball Inputs::widened(Ball b, const std::string& key) const
{
    if (const auto h = half_widths_.find(key); h != half_widths_.end()) arb_add_error(b.get(), Ball(h->second).get());
    return b;
}

Inputs Inputs::box(std::map<std::string, Rational> half_widths) const
{
    Inputs all = *this;
    all.half_widths_ = std::move(half_widths);
    return all;
}

int Inputs::compare_G(const Rational& with) const
{
    try {
        const Exact G = G_exact();
        if (G == Exact(with)) return 0;
        return certainly(less(G, Exact(with))) ? -1 : 1;
    }
    catch (const NotExact&) {
        // G = gamma^(p/q) in lowest terms is rational only if gamma is a perfect q-th power, which Exact finds unless
        // numbers of more than a million bits are in play. So G differs from `with`, and balls tell on which side.
        for (slong bits = 64; bits <= 1L << 22; bits *= 2) {
            const WorkingPrecision precision(bits);
            const Truth t = less(G_ball(), Ball(with));
            if (t != Truth::unknown) return t == Truth::yes ? -1 : 1;
        }
        throw BeyondReach("G cannot be told from " + with.get_str() + " with four million bits");
    }
}

Plan plan_of(const Quantity& q, const Inputs& in, Accuracy wanted)
{
    if (q.plan) return q.plan(in, wanted);
    Plan plan;
    for (const Route& r : q.routes)
        plan.proofs.push_back({r.name, [&r, &in](Accuracy a) {
                                   const WorkingPrecision precision(working_bits(a));
                                   return r.ball(in);
                               }});
    for (std::size_t i = 0; i < q.routes.size(); ++i)
        if (q.routes[i].halved_as_second && wanted.digits > proven_twice) plan.proofs[i].digits = looked_at_again(wanted).digits;
    if (wanted.digits > q.routes.front().leads_up_to) std::rotate(plan.proofs.begin(), plan.proofs.begin() + 1, plan.proofs.end());
    return plan;
}

std::vector<Certified> certified_where(const Quantity& q)
{
    if (!q.certified.empty()) return q.certified;
    const Route &first = q.routes.at(0), &second = q.routes.at(1);
    const std::string everywhere = "everywhere in its domain", shared = "what the quantity is defined as, and ball arithmetic";
    if (first.leads_up_to == any_digits) return {{everywhere, "any", first.name, "proof " + second.name, shared}};
    const std::string few = std::to_string(first.leads_up_to);
    return {{everywhere, "up to " + few, first.name, "proof " + second.name, shared},
            {everywhere, "beyond " + few, second.name, "proof " + first.name, shared}};
}

Ball first_ball(const Quantity& q, const Inputs& in)
{
    if (!q.plan) return q.routes.front().ball(in);
    constexpr long most = 20; // what binary64 codes are judged by
    const Accuracy wanted{std::min(most, accuracy_of(WorkingPrecision::bits()).digits)};
    const Plan plan = plan_of(q, in, wanted);
    if (plan.proofs.empty()) throw BeyondReach(plan.refusal);
    return plan.proofs.front().ball({std::min(wanted.digits, plan.most_digits)});
}

const std::vector<Quantity>& catalogue()
{
    static const std::vector<Quantity> all = [] {
        std::vector<Quantity> q;
        add_westergaard(q);
        add_gap(q);
        add_weierstrass(q);
        add_peaks(q);
        add_contact(q);
        add_archard(q);
        add_segments(q);
        add_limit(q);
        return q;
    }();
    return all;
}

const Quantity* find_quantity(std::string_view name)
{
    const auto& all = catalogue();
    const auto it = std::find_if(all.begin(), all.end(), [name](const Quantity& q) { return q.name == name; });
    return it == all.end() ? nullptr : &*it;
}

std::vector<std::string> quantity_names()
{
    std::vector<std::string> names;
    for (const auto& q : catalogue()) names.push_back(q.name);
    return names;
}

std::string nearest_name(std::string_view typed, const std::vector<std::string>& names)
{
    const auto distance = [typed](const std::string& name) { // Levenshtein
        std::vector<std::size_t> row(name.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t{0});
        for (const char c : typed) {
            std::size_t diagonal = row[0]++;
            for (std::size_t j = 0; j < name.size(); ++j) {
                const std::size_t up = row[j + 1];
                row[j + 1] = std::min({up + 1, row[j] + 1, diagonal + (c == name[j] ? 0 : 1)});
                diagonal = up;
            }
        }
        return row.back();
    };
    const std::string* nearest = &names.front();
    std::size_t least = distance(*nearest);
    for (const std::string& name : names) {
        const std::size_t letters = std::max(name.size(), typed.size()) - std::min(name.size(), typed.size()); // no distance is less
        if (letters >= least) continue;
        if (const std::size_t d = distance(name); d < least) {
            least = d;
            nearest = &name;
        }
    }
    return *nearest;
}

void require(bool holds, const Inputs& in, const std::string& key, std::string_view right)
{
    if (!holds) throw DomainError(fmt::format("{} = {}: must be {}", key, in.real(key).get_str(), right));
}

void require_integer(const Inputs& in, const std::string& key, long least, long most)
{
    const Rational& v = in.real(key);
    require(v.get_den() == 1 && v >= least && v <= most, in, key, fmt::format("an integer from {} to {}", least, most));
}

void require_load(const Inputs& in) { require(in.real("load") > 0, in, "load", "> 0"); }

void require_surface(const Inputs& in)
{
    if (in.has("G")) {
        require(in.real("G") > 1, in, "G", "> 1");
        return;
    }
    require(in.real("D") > 1 && in.real("D") < 2, in, "D", "> 1 and < 2");
    require(in.real("gamma") > 1, in, "gamma", "> 1");
}

} // namespace touchstone
