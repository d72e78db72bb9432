// SPDX-License-Identifier: MIT
#include "touchstone/table/working_order.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace touchstone {
namespace {

std::string text(const Inputs& in, const char* key) { return in.has(key) ? in.real(key).get_str(62) + "," : std::string(","); }

bool has_surface(const Quantity& q)
{
    return std::any_of(q.inputs.begin(), q.inputs.end(), [](const auto& key) { return key == "G" || key == "gamma"; });
}

std::string surface(const Inputs& in) { return text(in, "G") + text(in, "D") + text(in, "gamma"); }

/// What the rows that share one discretisation have in common. Only a choice of order, so that a quick comparison of G is enough.
struct Shared {
    std::string surface, other;
    /// Less is more demanding.
    Rational demand;
};

Shared shared(const Inputs& in)
{
    Shared s{surface(in), "", in.has("load") ? in.real("load") : Rational(0)};
    const char* place = in.has("p") ? "p" : in.has("a") ? "a" : nullptr;
    const bool full = in.has("load") && (in.real("load") > 1 || (in.has("G") && in.real("G") <= 2));
    if (full) s.demand = -s.demand; // meshes reach up to the load
    if (place == nullptr) return s;
    s.other = full ? text(in, place) + text(in, "n") : text(in, "load");
    if (!full) s.demand = in.real(place); // small pressures want levels to more digits
    return s;
}

} // namespace

std::string surface_text(const Quantity& q, const Inputs& in) { return has_surface(q) ? surface(in) : std::string(); }

std::vector<std::size_t> working_order(const Quantity& q, const std::vector<const Inputs*>& rows)
{
    std::vector<std::size_t> order;
    const bool sharing = has_surface(q);
    std::map<std::pair<std::string, std::string>, std::size_t> group_of;
    std::map<std::string, std::size_t> surface_of;
    struct Group {
        std::size_t surface;
        std::vector<std::size_t> rows;
        std::size_t hardest; ///< place in rows
        Rational demand;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] == nullptr) continue;
        if (!sharing) {
            order.push_back(i);
            continue;
        }
        const Shared s = shared(*rows[i]);
        const std::size_t surface = surface_of.try_emplace(s.surface, surface_of.size()).first->second;
        const auto [at, fresh] = group_of.try_emplace({s.surface, s.other}, groups.size());
        if (fresh) groups.push_back({surface, {}, 0, s.demand});
        Group& g = groups[at->second];
        g.rows.push_back(i);
        if (s.demand < g.demand) {
            g.demand = s.demand;
            g.hardest = g.rows.size() - 1;
        }
    }
    std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.surface < b.surface; });
    for (Group& g : groups) {
        std::rotate(g.rows.begin(), g.rows.begin() + static_cast<long>(g.hardest), g.rows.begin() + static_cast<long>(g.hardest) + 1);
        order.insert(order.end(), g.rows.begin(), g.rows.end());
    }
    return order;
}

} // namespace touchstone
