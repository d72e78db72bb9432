// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/operator/own.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::proofs {

ex Constants::exact(std::size_t i) const
{
    const Rational r(all_.at(i).value); // every binary64 number is a rational one
    return ex(GiNaC::numeric(r.get_str().c_str()));
}

namespace {

std::string with_constants(std::string text, const std::vector<Constant>& constants)
{
    for (std::size_t i = 0; i < constants.size(); ++i) {
        const std::string mark = fmt::format("{{{}}}", i), value = fmt::format("{:.15g}", constants[i].value);
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) text.replace(at, mark.size(), value);
    }
    return text;
}

} // namespace

CheckedLemma run(const OwnClaim& c)
{
    CheckedLemma e{&c, with_constants(c.statement, c.constants), c.judge(Constants(c.constants)), {}};
    for (const OwnClaim::Perturbed& p : c.controls) {
        std::vector<Constant> perturbed = c.constants;
        Constant& changed = perturbed.at(p.which);
        const std::string what = fmt::format("{} {:.15g} -> {:.15g}", changed.name, changed.value, p.value);
        changed.value = p.value;
        e.controls.push_back({what, c.judge(Constants(perturbed))});
    }
    return e;
}

std::vector<std::string> CheckedLemma::failures() const
{
    std::vector<std::string> all;
    if (finding.verdict != Verdict::proved && finding.verdict != Verdict::verified)
        all.push_back(fmt::format("{}: {}", name(finding.verdict), finding.reason));
    if (controls.empty()) all.push_back("no perturbed constant to be refuted");
    for (const auto& k : controls)
        if (k.finding.verdict != Verdict::refuted) all.push_back(fmt::format("control '{}' is {}", k.what, name(k.finding.verdict)));
    return all;
}

void Worst::below(const Ball& value, const Ball& bound, const std::string& where)
{
    const double share = arf_get_d(arb_midref((value / bound).get()), ARF_RND_NEAR);
    ++points_;
    sum_ += share;
    most_ = std::max(most_, share);
    if (refuted_.empty() && !certainly(less(value, bound)))
        refuted_ = where + ": " + value.to_string(6) + ", not below " + bound.to_string(6);
}

Check Worst::result() const
{
    if (!refuted_.empty()) return {Verdict::refuted, refuted_};
    return {Verdict::verified, fmt::format("at {} points, at most {:.6g} of it, {:.6g} on average", points_, most_, sum_ / points_)};
}

const std::vector<OwnClaim>& own_claims()
{
    static const std::vector<OwnClaim> all = [] {
        std::vector<OwnClaim> claims;
        for (auto part : {operator_claims, approximation_claims, partial_contact_claims, full_contact_claims, two_waves_claims,
                          distribution_claims, rounding_claims})
            for (OwnClaim& c : part()) claims.push_back(std::move(c));
        return claims;
    }();
    return all;
}

} // namespace touchstone::proofs
