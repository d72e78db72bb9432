// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_symbols.hpp"

#include "proofs/symbolic/symbolic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <vector>

namespace touchstone::proofs {

std::set<std::string> words(const std::string& text)
{
    static const std::regex word(R"([A-Za-z]\w*)");
    std::set<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) all.insert(it->str());
    return all;
}

std::set<std::string> symbols_of(const ex& e)
{
    std::set<std::string> all;
    const std::function<void(const ex&)> collect = [&](const ex& part) {
        if (GiNaC::is_a<GiNaC::symbol>(part)) all.insert(GiNaC::ex_to<GiNaC::symbol>(part).get_name());
        for (std::size_t i = 0; i < part.nops(); ++i) collect(part.op(i));
    };
    collect(e);
    return all;
}

ex written_out(const OwnLedger& ledger, const ex& e, const std::function<bool(const std::string&)>& is_meant)
{
    for (const std::string& name : symbols_of(e)) // and no others, which keep the sign that they are first named with
        if (const auto symbol = ledger.symbols.find(name); symbol != ledger.symbols.end() && !symbol->second.is.empty() && is_meant(name))
            return written_out(ledger, with_put_in(e, {{sym(name), read(symbol->second.is)}}), is_meant);
    return e; // what stands for what has no cycle
}

ex written_out(const OwnLedger& ledger, const ex& e)
{
    return written_out(ledger, e, [](const std::string&) { return true; });
}

double terms_of(const ex& e)
{
    double sum = 0, product = 1, most = 1;
    for (std::size_t i = 0; i < e.nops(); ++i) {
        const double terms = terms_of(e.op(i));
        sum += terms;
        product *= terms;
        most = std::max(most, terms);
    }
    if (GiNaC::is_a<GiNaC::add>(e)) return sum;
    if (GiNaC::is_a<GiNaC::mul>(e)) return product;
    if (!GiNaC::is_a<GiNaC::power>(e) || !e.op(1).info(GiNaC::info_flags::integer)) return most;
    const double terms = terms_of(e.op(0)), n = GiNaC::ex_to<GiNaC::numeric>(GiNaC::abs(e.op(1))).to_double();
    return terms < 2 ? 1 : std::exp(std::lgamma(n + terms) - std::lgamma(n + 1) - std::lgamma(terms)); // ways to choose n of them
}

namespace {

ex number(const Rational& x) { return ex(GiNaC::numeric(x.get_str().c_str())); }

/// The least value of e in a box, if e has no power of a symbol in it, so that this is at a corner, and is a rational number there.
std::optional<ex> least_at_corners(const ex& e, const std::vector<Range>& box)
{
    constexpr std::size_t most_symbols = 8;
    if (box.size() > most_symbols || terms_of(e) > most_terms) return std::nullopt;
    const ex expanded = GiNaC::expand(e);
    for (const Range& r : box)
        if (!expanded.is_polynomial(sym(r.symbol)) || expanded.degree(sym(r.symbol)) > 1) return std::nullopt;
    std::optional<ex> least;
    for (std::size_t corner = 0; corner < (std::size_t{1} << box.size()); ++corner) {
        GiNaC::lst at;
        for (std::size_t i = 0; i < box.size(); ++i) at.append(sym(box[i].symbol) == number(corner >> i & 1 ? box[i].high : box[i].low));
        const ex value = expanded.subs(at);
        if (!GiNaC::is_a<GiNaC::numeric>(value) || !GiNaC::ex_to<GiNaC::numeric>(value).is_rational()) return std::nullopt;
        if (!least || GiNaC::ex_to<GiNaC::numeric>(value) < GiNaC::ex_to<GiNaC::numeric>(*least)) least = value;
    }
    return least;
}

} // namespace

Check not_negative(const OwnLedger& ledger, const ex& e)
{
    const ex full = written_out(ledger, e);
    std::vector<Range> box;
    for (const std::string& name : symbols_of(full)) box.push_back({name, ledger.symbols.at(name).low, ledger.symbols.at(name).high});
    if (box.empty()) {
        const Truth negative = less(evaluate(full, Point{}), Ball(0));
        return {certainly(negative) ? Verdict::refuted : possibly(negative) ? Verdict::undecided : Verdict::proved, str(full)};
    }
    if (const auto least = least_at_corners(full, box))
        return {least->info(GiNaC::info_flags::negative) ? Verdict::refuted : Verdict::proved, "it is " + str(*least) + " at least"};
    constexpr int pieces = 500;
    return positive_on(full, box, pieces, Bound::may_be_reached);
}

} // namespace touchstone::proofs
