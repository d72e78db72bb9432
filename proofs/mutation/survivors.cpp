// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/mutation/survivors.hpp"

#include "proofs/mutation/typesetter.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace touchstone::data {
std::string_view excuses_text();
}

namespace touchstone::proofs {

namespace {

/// (entry, change) -> reason.
using Excuses = std::map<std::pair<std::string, std::string>, std::string>;

const Excuses& excuses()
{
    static const Excuses all = [] {
        Excuses e;
        for (const auto& record : nlohmann::json::parse(data::excuses_text()))
            for (const auto& change : record.at("changes"))
                if (!e.emplace(std::pair<std::string, std::string>{record.at("id"), change}, record.at("reason")).second)
                    throw std::logic_error("excused twice: " + record.at("id").get<std::string>() + " " + change.get<std::string>());
        return e;
    }();
    return all;
}

} // namespace

int Mutation::unexcused() const
{
    return static_cast<int>(std::count_if(survivors.begin(), survivors.end(), [](const Survivor& s) { return s.excuse.empty(); }));
}

Mutation mutate(const std::vector<const Claim*>& some, int stride, int offset, const std::function<void(std::size_t)>& judged)
{
    Mutation m;
    std::set<std::pair<std::string, std::string>> used;
    int counter = 0;
    std::size_t claims_done = 0;
    for (const Claim* claim : some) {
        // Of a print that is false the corrected form: the changes of what is false are false already.
        const Print& printed = prints().at(claim->id);
        const Print right = claim->correction ? printed.edited(claim->correction->edits) : printed;
        for (const Change& change : typesetters_changes(right)) {
            if (counter++ % stride != offset) continue;
            ++m.changes;
            ++m.by_kind[change.kind];
            Survivor s{claim->id, change.name, change.kind, "", "", ""};
            try {
                const Finding f = judge_whole(*claim, change.print, Order::reading_first);
                s.verdict = name(f.verdict);
                s.reason = f.reason;
                if (f.verdict == Verdict::refuted) {
                    ++m.refuted;
                    m.caught.push_back(std::move(s));
                    continue;
                }
            } catch (const std::exception& e) {
                s.verdict = "exception";
                s.reason = e.what();
            }
            const auto excuse = excuses().find({s.id, s.change});
            if (excuse != excuses().end()) {
                s.excuse = excuse->second;
                used.insert(excuse->first);
            }
            m.survivors.push_back(std::move(s));
        }
        if (judged) judged(++claims_done);
    }
    if (stride == 1)
        for (const auto& [key, reason] : excuses())
            if (!used.count(key) && std::any_of(some.begin(), some.end(), [&](const Claim* c) { return c->id == key.first; }))
                m.idle_excuses.push_back(key.first + "  " + key.second);
    return m;
}

} // namespace touchstone::proofs
