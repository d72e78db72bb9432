// SPDX-License-Identifier: MIT
#include "touchstone/oracle/mixup.hpp"

#include "touchstone/oracle/mistakes.hpp"
#include "touchstone/oracle/regime.hpp"
#include "touchstone/rounding/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace touchstone::oracle {
namespace {

constexpr std::size_t most_rows = 96;      ///< on which candidates are tried
constexpr std::size_t fewest_rows = 3;     ///< that can tell anything
constexpr slong bits = 160;
constexpr std::array closeness{0x1p-20, 1e-4, 1e-3, 1e-2, 5e-2};
constexpr double loosest_partial = 1e-3;   ///< beyond this two fifths of the rows may agree by chance
constexpr double enough = 0.9, partial = 0.4;
constexpr double tie = 0.02;               ///< shares closer than this are the same, and the simpler explanation wins

/// The rows looked at. A candidate that would have answered v is compared through answer/v and v.
struct Evidence {
    Inputs in;
    Ball truth, answer;
};

/// What one candidate makes of a row: the answer it would have given, and the ratio of the real one to it (NaN: 0/0).
struct Candidate {
    double value, ratio;
};

double middle(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

std::optional<Candidate> candidate(const Ball& answer, const Ball& value)
{
    if (!value.is_finite()) return std::nullopt;
    if (arb_is_zero(value.get())) return Candidate{0, arb_is_zero(answer.get()) ? 1 : std::numeric_limits<double>::infinity()};
    if (value.contains_zero()) return std::nullopt;
    return Candidate{middle(value), middle(answer / value)};
}

/// Whether answer = factor * value to the tolerance.
bool alike(const Candidate& c, double factor, const Tolerance& t)
{
    const double off = std::fabs(c.ratio / factor - 1);
    return off <= t.relative || off * std::fabs(c.value * factor) <= t.absolute;
}

/// At most `most_rows` of them in their order, by multiples of the golden section: every k-th row of a grid may all be of one kind.
std::vector<std::size_t> spread(const std::vector<std::size_t>& all)
{
    if (all.size() <= most_rows) return all;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < most_rows; ++k) {
        const double turns = static_cast<double>(k) / std::numbers::phi;
        some.push_back(all[static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(all.size()))]);
    }
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
    return some;
}

std::vector<Evidence> evidence(const Quantity& q, const std::vector<Question>& questions, const std::vector<double>& answers,
                               const std::vector<std::size_t>& chosen)
{
    std::vector<Evidence> rows;
    for (const std::size_t i : spread(chosen))
        if (std::isfinite(answers[i]))
            rows.push_back({exact_inputs(q, questions[i].inputs), Ball(questions[i].truth.value), Ball::exactly(answers[i])});
    return rows;
}

/// The value at other inputs; a costly one only if a row has it.
class Elsewhere {
public:
    Elsewhere(const Quantity& q, const std::vector<Question>& questions) : q_(q)
    {
        if (!of_the_recursion(q)) return;
        for (const auto& question : questions) known_.emplace(exact_inputs(q, question.inputs).values(), Ball(question.truth.value));
    }
    std::optional<Ball> operator()(std::map<std::string, Rational> values) const
    {
        if (of_the_recursion(q_)) {
            const auto row = known_.find(values);
            return row == known_.end() ? std::nullopt : std::optional(row->second);
        }
        try {
            const Inputs in(std::move(values));
            q_.check(in);
            return first_ball(q_, in);
        }
        catch (const DomainError&) {
            return std::nullopt;
        }
        catch (const BeyondReach&) {
            return std::nullopt;
        }
    }

private:
    const Quantity& q_;
    std::map<std::map<std::string, Rational>, Ball> known_;
};

/// One explanation tried: for each row what it would have answered, up to a factor for each row.
struct Explanation {
    std::string name;
    int cost;
    const std::vector<std::optional<Candidate>>* values;
    std::vector<double> factors;
    bool fitted = false; ///< made from the answers themselves: it must hold throughout
};

struct Score {
    std::size_t telling = 0, matched = 0;
    double share() const { return telling < fewest_rows ? 0 : static_cast<double>(matched) / static_cast<double>(telling); }
};

class Trial {
public:
    Trial(const std::vector<std::optional<Candidate>>& truth, const Tolerance& t) : truth_(truth), tolerance_(t)
    {
        for (const auto& row : truth_) {
            right_.push_back(row && alike(*row, 1, t));
            right_count_ += right_.back();
            const bool tells = row && row->value != 0; // a zero outside the contact is right in every unit
            telling_ += tells;
            right_telling_ += tells && right_.back();
        }
    }
    /// Share of the rows other than zero that are right as they are.
    double right() const { return telling_ == 0 ? 0 : static_cast<double>(right_telling_) / static_cast<double>(telling_); }
    Score score(const Explanation& e) const
    {
        Score s;
        std::size_t covered = 0;
        for (std::size_t i = 0; i < truth_.size(); ++i) {
            const auto& c = (*e.values)[i];
            if (!c || !truth_[i]) continue;
            const bool same = std::fabs(c->value * e.factors[i] - truth_[i]->value) <= tolerance_.relative * std::fabs(truth_[i]->value);
            if (right_[i] && same) continue;
            ++s.telling;
            covered += !right_[i];
            s.matched += alike(*c, e.factors[i], tolerance_);
        }
        // what it says nothing about it does not explain: at least half of the wrong rows must be covered
        return 2 * covered < truth_.size() - right_count_ ? Score{} : s;
    }

private:
    const std::vector<std::optional<Candidate>>& truth_;
    Tolerance tolerance_;
    std::vector<bool> right_;
    std::size_t right_count_ = 0, telling_ = 0, right_telling_ = 0;
};

double quantile(std::vector<double> v, double part)
{
    const auto at = v.begin() + static_cast<long>(std::min(v.size() - 1, static_cast<std::size_t>(part * static_cast<double>(v.size()))));
    std::nth_element(v.begin(), at, v.end());
    return *at;
}

/// A factor that is in no list, to the digits that the answers agree on, and the Poisson's ratio it would be.
std::string fitted_name(const Ratio& ratio)
{
    constexpr double fewest = 2, most_shown = 9;
    const double c = ratio.median;
    const double spread = std::max(std::fabs((ratio.upper - ratio.lower) / c), 1e-16);
    std::string name =
        fmt::format("factor {:#.{}g} throughout", c, static_cast<int>(std::clamp(std::ceil(-std::log10(spread)), fewest, most_shown)));
    const double complement = c < 1 ? 1 - c : 1 - 1 / c;
    constexpr double least = 1e-3, most = 0.25; // nu from 0.03 to 0.5
    if (c > 0 && complement >= least && complement <= most)
        name += fmt::format(": {} with nu = {:.4g}", c < 1 ? "1 - nu^2, E for E/(1 - nu^2)," : "1/(1 - nu^2), E/(1 - nu^2) for E,",
                            std::sqrt(complement));
    return name;
}

/// Everything that is tried, made once and scored at each closeness.
class Explanations {
public:
    Explanations(const Quantity& q, const std::vector<Question>& questions, const std::vector<Evidence>& rows, const Ratio& ratio)
    {
        const Elsewhere elsewhere(q, questions);
        const auto outputs = output_mistakes(q);
        std::vector<std::vector<double>> factors;
        for (const auto& o : outputs) {
            factors.emplace_back();
            for (const auto& e : rows) factors.back().push_back(o.factor(e.in));
        }
        const std::vector<double> ones(rows.size(), 1);
        for (const auto& f : other_formulas(q))
            all_.push_back({f.name, 1, add(rows, [&](const Evidence& e) { return std::optional(f.value(e.in)); }), ones});
        for (const auto& mistake : input_mistakes(q)) {
            const auto* values = add(rows, [&](const Evidence& e) -> std::optional<Ball> {
                auto moved = e.in.values();
                if (mistake.cost == 0) return e.truth;
                return mistake.apply(moved) ? elsewhere(std::move(moved)) : std::nullopt;
            });
            if (mistake.cost == 0) truth_ = values;
            for (std::size_t k = 0; k < outputs.size(); ++k) {
                const auto& o = outputs[k];
                if (mistake.cost == 0 && o.cost == 0) continue;
                const std::string name = mistake.name.empty() ? o.name : o.name.empty() ? mistake.name : mistake.name + "; " + o.name;
                all_.push_back({name, mistake.cost + o.cost, values, factors[k]});
            }
        }
        const auto* complement = add(rows, [](const Evidence& e) { return std::optional<Ball>(1 - e.truth); });
        if (q.name.ends_with("exceedance")) all_.push_back({"1 - value: the share below p for the share above it", 1, complement, ones});
        if (ratio.median != 0 && std::isfinite(ratio.median))
            all_.push_back({fitted_name(ratio), 3, truth_, std::vector<double>(rows.size(), ratio.median), true});
        std::vector<double> offsets, sizes;
        for (const auto& e : rows) {
            offsets.push_back(middle(e.answer - e.truth));
            sizes.push_back(std::fabs(middle(e.truth)));
        }
        const double offset = quantile(offsets, 0.5);
        if (std::fabs(offset) > 0x1p-30 * quantile(sizes, 0.5)) {
            // an offset is the same where it is large beside the value too: there the difference itself must agree
            const auto* moved = add(rows, [&](const Evidence& e) { return std::optional<Ball>(e.truth + Ball::exactly(offset)); });
            all_.push_back({fmt::format("constant offset {:.7g} throughout", offset), 3, moved, ones, true});
        }
    }
    const std::vector<Explanation>& all() const { return all_; }
    const std::vector<std::optional<Candidate>>& truth() const { return *truth_; }

private:
    template <class Value>
    const std::vector<std::optional<Candidate>>* add(const std::vector<Evidence>& rows, Value value)
    {
        auto values = std::make_unique<std::vector<std::optional<Candidate>>>();
        for (const auto& e : rows) {
            const std::optional<Ball> v = value(e);
            values->push_back(v ? candidate(e.answer, *v) : std::nullopt);
        }
        kept_.push_back(std::move(values));
        return kept_.back().get();
    }
    std::vector<std::unique_ptr<std::vector<std::optional<Candidate>>>> kept_;
    std::vector<Explanation> all_;
    const std::vector<std::optional<Candidate>>* truth_ = nullptr;
};

std::optional<MixUp> best_at(const Explanations& explanations, const Tolerance& t, double least)
{
    const Trial trial(explanations.truth(), t);
    MixUp best;
    int cost = 0;
    std::size_t matched = 0;
    for (const Explanation& e : explanations.all()) {
        const Score s = trial.score(e);
        const double share = s.share();
        if (share < (e.fitted ? enough : least) || share < 2 * trial.right()) continue;
        const bool simpler = e.cost < cost || (e.cost == cost && s.matched > matched); // or it speaks of more rows
        if (share > best.explains + tie || (share > best.explains - tie && simpler)) {
            best = {e.name, share, t.relative, s.telling - s.matched};
            cost = e.cost;
            matched = s.matched;
        }
    }
    return best.name.empty() ? std::nullopt : std::optional(best);
}

/// Where truth and answer are numbers other than zero.
Ratio ratio_of(const std::vector<Question>& questions, const std::vector<double>& answers, const std::vector<std::size_t>& chosen)
{
    std::vector<double> ratios;
    for (const std::size_t i : chosen)
        if (std::isfinite(answers[i]) && questions[i].truth.value != 0)
            ratios.push_back(nearest_double(Rational(exact_rational(answers[i]) / questions[i].truth.value)));
    if (ratios.empty()) return {};
    return {ratios.size(), quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75)};
}

/// What the answers look like as numbers, whatever the quantity.
void look_at_the_numbers(const std::vector<Question>& questions, const std::vector<double>& answers, std::vector<std::string>& findings)
{
    constexpr std::size_t fewest = 8, few_digits = 12;
    constexpr double most = 0.95;
    std::vector<double> lengths;
    std::size_t single = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const double a = answers[i];
        if (!std::isfinite(a) || a == 0 || a == nearest_double(questions[i].truth.value)) continue; // a short number may be the right one
        single += static_cast<double>(static_cast<float>(a)) == a;
        const std::string text = shortest(std::fabs(a));
        const std::string digits = text.substr(0, text.find('e'));
        const auto first = digits.find_first_not_of("0.");
        lengths.push_back(static_cast<double>(std::count_if(digits.begin() + static_cast<long>(std::min(first, digits.size())),
                                                            digits.end(), [](char c) { return c != '.'; })));
    }
    if (lengths.size() < fewest) return;
    const double digits = quantile(lengths, most);
    if (digits <= static_cast<double>(few_digits)) {
        std::size_t right = 0;
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (std::isfinite(answers[i]) && questions[i].truth.value != 0)
                right += abs(Rational(exact_rational(answers[i]) / questions[i].truth.value - 1)) <=
                         power(Rational(10), 1 - static_cast<long>(digits));
        findings.push_back(fmt::format(
            "answers carry {:.0f} significant digits, and {} of {} are right to a unit of the last: print 17 (%.17g, es24.16e3, repr)",
            digits, right, answers.size()));
    }
    else if (static_cast<double>(single) >= most * static_cast<double>(lengths.size()))
        findings.push_back("answers are single-precision numbers (float32, 24 bits): somewhere on the way they were rounded to that");
}

/// A code that answers one number whatever it is asked: any candidate with a plateau would seem to explain it.
bool one_answer_to_all(const std::vector<Question>& questions, const std::vector<double>& answers)
{
    const auto other = [&](std::size_t i) { return questions[i].truth.value != questions.front().truth.value; };
    bool asked_more = false;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i] != answers.front()) return false;
        asked_more = asked_more || other(i);
    }
    return asked_more;
}

/// Some of the rows, and what would explain them.
class Part {
public:
    Part(const Quantity& q, const std::vector<Question>& questions, const std::vector<double>& answers,
         const std::vector<std::size_t>& chosen)
        : rows_(evidence(q, questions, answers, chosen))
    {
        if (!empty()) explanations_.emplace(q, questions, rows_, ratio_of(questions, answers, chosen));
    }
    bool empty() const { return rows_.size() < fewest_rows; }
    /// From tight to loose the first candidate that gives at least this share of the telling rows.
    std::optional<MixUp> best(const Tolerance& asked, double least) const
    {
        if (empty()) return std::nullopt;
        for (const double close : closeness) {
            if (least == partial && close > loosest_partial) break;
            if (auto found = best_at(*explanations_, {std::max(close, asked.relative), asked.absolute}, least)) return found;
        }
        return std::nullopt;
    }

private:
    std::vector<Evidence> rows_;
    std::optional<Explanations> explanations_;
};

} // namespace

Diagnosis diagnose(const Quantity& q, const std::vector<Question>& questions, const std::vector<double>& answers, const Tolerance& asked,
                   bool look_for_mixup)
{
    Diagnosis d;
    std::vector<std::size_t> all(questions.size()), ordinary;
    std::iota(all.begin(), all.end(), std::size_t{0});
    d.ratio = ratio_of(questions, answers, all);
    if (look_for_mixup && answers.size() >= fewest_rows && one_answer_to_all(questions, answers)) {
        d.findings.push_back(fmt::format("all {} answers are {}, whatever is asked", answers.size(), shortest(answers.front())));
        return d;
    }
    look_at_the_numbers(questions, answers, d.findings);
    if (!look_for_mixup) return d;
    const WorkingPrecision precision(bits);
    std::copy_if(all.begin(), all.end(), std::back_inserter(ordinary),
                 [&](std::size_t i) { return regime_of(q, questions[i]) == "ordinary"; });
    const Part every(q, questions, answers, all);
    d.mixup = every.best(asked, enough);
    if (d.mixup || every.empty()) return d;
    const Part usual(q, questions, answers, ordinary.size() < all.size() ? ordinary : std::vector<std::size_t>{});
    if ((d.mixup = usual.best(asked, enough))) d.mixup->ordinary_only = true;
    else if (!(d.mixup = every.best(asked, partial)) && (d.mixup = usual.best(asked, partial))) d.mixup->ordinary_only = true;
    return d;
}

} // namespace touchstone::oracle
