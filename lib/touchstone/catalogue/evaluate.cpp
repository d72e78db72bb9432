// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"

#include "touchstone/scalar/second_look.hpp"
#include "touchstone/scalar/thread_caches.hpp"

#include <fmt/format.h>

#include <future>

namespace touchstone {
namespace {

Evaluation from_rational(const Rational& r, long digits, std::vector<std::string> routes)
{
    Evaluation e;
    const auto length = terminating_digits(r);
    const bool whole = length && *length <= digits;
    const Decimal d = round_to_digits(r, whole ? *length : digits);
    e.value = d.text(digits);
    e.error_bound = whole ? "0" : d.half_unit();
    e.digits = d.digits.empty() ? 1 : static_cast<long>(d.digits.size());
    e.status = whole ? Status::exact : Status::certified;
    e.proven = true;
    e.binary64 = nearest_double(r);
    e.routes = std::move(routes);
    const WorkingPrecision precision(bits_for_digits(digits) + 32);
    e.ball = Ball(r);
    return e;
}

std::optional<Exact> exact_result(const Quantity& q, const Inputs& in)
{
    if (!q.exact) return std::nullopt;
    try {
        return q.exact(in);
    }
    catch (const NotExact&) {
        return std::nullopt;
    }
}

/// At this accuracy a binary64 number is decided unless the value is next to a tie of two of them.
constexpr long binary64_digits = 18;
/// Beyond the digits that a method ever proves it is asked for no more than these, for values next to a tie.
constexpr long digits_to_spare = 8;
/// Where a proof refuses the digits asked for, it is asked for these before anything unproven is shown.
constexpr long fewer_digits = 15;
/// A witness disagrees when it is off by so many times its own error, and by so much of the value.
constexpr long witness_error_factor = 64;
constexpr long witness_digits = 15;
/// From here on the proofs of a formula run side by side. Each thread computes its own constants and Bernoulli numbers: below, that is most
/// of the work.
constexpr long digits_worth_a_thread = 3000;
/// It is asked for the digits that a second proof would look at, and so many more, not for all that it could give.
constexpr long witness_spare_digits = 2;

template <class F>
auto start(bool own_thread, F f)
{
    return std::async(own_thread ? std::launch::async : std::launch::deferred, [own_thread, f] {
        if (own_thread) release_caches_with_thread();
        return f();
    });
}

/// The decimal that all of these balls round to.
std::optional<Decimal> common_digits(const std::vector<Ball>& balls, long digits)
{
    const auto first = round_to_digits(balls.front(), digits);
    for (const Ball& b : balls)
        if (!first || round_to_digits(b, digits) != first) return std::nullopt;
    return first;
}

std::optional<double> common_double(const std::vector<Ball>& balls)
{
    const auto first = nearest_double(balls.front());
    for (const Ball& b : balls)
        if (!first || nearest_double(b) != first) return std::nullopt;
    return first;
}

/// As many digits as the balls decide, each alone, up to `digits`; may be none.
void show_what_is_known(Evaluation& e, const std::vector<Ball>& balls, long digits, long width)
{
    for (long n = digits; n >= 1; --n)
        if (const auto d = common_digits(balls, n)) {
            e.value = d->text(width);
            e.error_bound = d->half_unit();
            e.digits = n;
            return;
        }
    e.value = "nan";
    e.error_bound = "inf";
    e.digits = 0;
}

/// The accuracies at which digits are searched for: a formula's precision is doubled, a dear proof is asked for few digits more.
/// The last is always the limit, whatever the first was: what is decided does not depend on the start.
class Ladder {
public:
    /// \param most_digits that are ever proven: a ball that more accuracy does not narrow is not asked for again and again
    Ladder(const EvaluationOptions& o, long digits, bool dear, long most_digits) : digits_(digits), dear_(dear)
    {
        limit_ = o.limit_bits > 0 ? accuracy_of(o.limit_bits).digits : accuracy_of(16 * working_bits({digits}) + 8192).digits;
        if (most_digits < any_digits) limit_ = std::min(limit_, most_digits + digits_to_spare);
        at_ = o.start_bits > 0 ? accuracy_of(o.start_bits).digits : dear ? digits : std::max(digits, binary64_digits);
        if (dear) {
            limit_ = std::max(limit_, least_digits_of_dear);
            at_ = std::max(at_, least_digits_of_dear);
        }
        at_ = std::min(limit_, at_);
    }
    /// From what was asked for on, for a dear proof that refuses to begin with more.
    void begin_with_digits()
    {
        dear_ = true;
        at_ = std::min(limit_, digits_);
    }
    Accuracy at() const { return {at_}; }
    bool last() const { return at_ >= limit_; }
    void raise()
    {
        const long next = dear_ ? at_ + step_ : accuracy_of(2 * working_bits({at_})).digits;
        at_ = std::min({limit_, next, at_ < digits_ ? digits_ : next}); // from below, what was asked for is tried before more
        step_ *= 2;
    }

private:
    static constexpr long least_digits_of_dear = 1; ///< however few bits are allowed, where digits are asked for, not bits
    long digits_, at_ = 0, limit_ = 0, step_ = 2;
    bool dear_;
};

/// As narrow as a ball that decides so many digits is, were the value not next to a tie.
bool decides_but_for_ties(const Ball& b, long digits) { return arb_rel_accuracy_bits(b.get()) > (digits - 1) * 3322 / 1000 + 1; }

/// What all attempts to prove one value share.
class Search {
public:
    Search(const Quantity& q, const Plan& plan, const std::optional<Exact>& exact, const EvaluationOptions& options)
        : q_(q), plan_(plan), exact_(exact), options_(options), dear_(plan.dear || plan.most_digits < binary64_digits),
          witness_wants_(std::min(witness_digits, looked_at_again({options.digits}).digits + witness_spare_digits)),
          own_threads_(dear_ || q.costly || options.digits >= digits_worth_a_thread)
    {
        if (plan.proofs.size() == 1 && second_look())
            witness_ = start(own_threads_, [look = second_look(), digits = witness_wants_] { return look->witness({digits}); });
    }

    /// \returns whether e is decided, as far as proofs go: if not, nothing is proven, and e.note says why.
    bool prove(Evaluation& e)
    {
        long digits = std::min(options_.digits, plan_.most_digits);
        if (digits < options_.digits) reason_ = plan_.refusal;
        Ladder ladder(options_, digits, dear_, plan_.most_digits);
        for (bool is_first = true;; is_first = false) {
            try {
                if (attempt(e, ladder, digits)) break;
                if (ladder.last()) break;
                ladder.raise();
            }
            catch (const BeyondReach& refusal) {
                if (is_first && ladder.at().digits > digits) { // asked for the sake of binary64, or of the first precision, alone
                    dear_ = true;
                    balls_.clear();
                    ladder.begin_with_digits();
                    continue;
                }
                if (!balls_.empty()) { // what the last accuracy gave stays proven
                    e.note = refusal.what();
                    break;
                }
                e.note = refusal.what();
                if (digits <= fewer_digits || options_.digits <= fewer_digits) return false;
                reason_ = refusal.what();
                digits = fewer_digits;
                ladder = Ladder(options_, digits, dear_, plan_.most_digits);
                ladder.begin_with_digits();
            }
        }
        finish(e, digits);
        return true;
    }

private:
    /// \returns whether all digits, and binary64 where that is cheap, are decided
    bool attempt(Evaluation& e, const Ladder& ladder, long digits)
    {
        const Accuracy accuracy = ladder.at();
        const WorkingPrecision precision(working_bits(accuracy));
        e.bits = working_bits(accuracy);
        std::vector<std::future<Ball>> others;
        for (std::size_t i = 1; i < plan_.proofs.size(); ++i)
            others.push_back(start(own_threads_, [&proof = plan_.proofs[i], accuracy, digits] {
                // Raised like the first: else a proof that stays a little wide would be asked for the same again and again.
                return proof.ball(proof.digits >= digits ? accuracy : Accuracy{std::max(1L, proof.digits + accuracy.digits - digits)});
            }));
        const Ball first = decided_first_ ? *decided_first_ : plan_.proofs.front().ball(accuracy);
        const auto point = exact_value(first); // radius zero: the value itself, which the other proofs must contain
        balls_ = {first};
        point_.reset();
        decided_ = false; // until the others have been heard, which may refuse
        const bool first_decides = point || round_to_digits(first, digits);
        if (!first_decides && !ladder.last()) return false;
        if (dear_ && first_decides) decided_first_ = first;
        looked_again_ = {};
        bool confirmed = true;
        for (std::size_t i = 0; i < others.size(); ++i) {
            const Proof& other = plan_.proofs[i + 1];
            const Ball ball = others[i].get();
            if (!ball.overlaps(first))
                throw RoutesDisagree(fmt::format("{}: proofs '{}' and '{}' give disjoint balls {} and {}", q_.name, plan_.proofs[0].name,
                                                 other.name, first.to_string(), ball.to_string()));
            if (other.digits >= digits) balls_.push_back(ball);
            else confirmed = confirmed && decides_but_for_ties(ball, other.digits);
            looked_again_ = std::min(other.digits, digits);
        }
        point_ = point;
        if (point_) return true;
        if (exact_ && !exact_->ball().overlaps(first))
            throw RoutesDisagree(fmt::format("{}: ball {} misses the exact value", q_.name, first.to_string()));
        decided_ = confirmed && common_digits(balls_, digits).has_value(); // each alone decides what it is asked for
        return decided_ && (dear_ || common_double(balls_));
    }

    void finish(Evaluation& e, long digits)
    {
        if (point_) {
            Evaluation exact = from_rational(*point_, options_.digits, e.routes);
            exact.bits = e.bits;
            e = std::move(exact);
        }
        else {
            e.ball = balls_.front();
            e.proven = true;
            e.binary64 = common_double(balls_);
            show_what_is_known(e, balls_, digits, options_.digits);
            e.status = decided_ && digits == options_.digits ? Status::certified : Status::undecided;
            if (e.status == Status::certified) e.note.clear();
            else explain_missing_digits(e, digits);
        }
        look_again(e);
    }

    void explain_missing_digits(Evaluation& e, long digits) const
    {
        if (digits < options_.digits)
            e.note = fmt::format("{} digits are certified here, {} were asked for: {}", e.digits, options_.digits,
                                 reason_.empty() ? "no method proves more" : reason_);
        else if (plan_.most_digits < any_digits && !is_limited()) e.note = "no more digits are certified here";
        else if (e.note.empty()) e.note = fmt::format("not decided at {} bits; a larger --max-precision may", e.bits);
        if (plan_.proofs.size() > 1 && !looked_again_ && e.digits > 0)
            e.note += fmt::format("; the digits shown rest on '{}' alone", plan_.proofs.front().name);
    }

    /// Whether it is the caller's limit that leaves too few bits for the digits.
    bool is_limited() const { return options_.limit_bits > 0 && accuracy_of(options_.limit_bits).digits < options_.digits; }

    const Look* second_look() const
    {
        return plan_.own_witness ? &*plan_.own_witness : plan_.witnesses.empty() ? nullptr : &plan_.witnesses.front();
    }

    void look_again(Evaluation& e)
    {
        if (looked_again_) e.second_look = SecondLook{plan_.proofs[1].name, true, true, std::min(e.digits, *looked_again_), plan_.shares};
        if (!witness_) return;
        const auto add = [&e](const std::string& text) { e.note += (e.note.empty() ? "" : "; ") + text; };
        try {
            const WorkingPrecision precision(256);
            const Witness seen = witness_->get();
            SecondLook look = held_against(e.ball, second_look()->name, seen);
            if (!look.agrees) {
                if (auto other = agreeing_witness(e.ball, look.name, abs(seen.value - e.ball))) {
                    add(fmt::format("the witness '{}' is off here, {} digits agree", look.name, look.digits));
                    look = std::move(*other);
                }
                else
                    add(fmt::format(
                        "the witness '{}' DISAGREES: it gives {}, and {} digits agree; the proof stands, but one of the two has a fault: please report it",
                        look.name, seen.value.to_string(), look.digits));
            }
            e.routes.push_back(look.name + " (witness)");
            e.second_look = std::move(look);
        }
        catch (const BeyondReach& refusal) {
            add(fmt::format("no second look: {}", refusal.what()));
        }
    }

    /// \throws BeyondReach where the witness saw nothing, with which anything would agree
    SecondLook held_against(const Ball& proven, const std::string& name, const Witness& seen) const
    {
        if (!seen.value.is_finite() || !seen.error.is_finite()) throw BeyondReach(fmt::format("'{}' has no value here", name));
        const Ball off = abs(seen.value - proven), size = abs(proven),
                   allowed = witness_error_factor * seen.error + size * pow(Ball(10), Ball(-witness_wants_));
        SecondLook look{name, false, !certainly(less(allowed, off)), 0, plan_.shares};
        while (look.digits < most_estimated_digits + 5 && certainly(less(2 * off * pow(Ball(10), Ball(look.digits + 1)), size)))
            ++look.digits;
        return look;
    }

    /// A witness misjudges itself now and then, next to a singular point that its grid does not know: another one is asked before anybody
    /// is told of a fault.
    /// \param fault by which the first is off: a witness that is vaguer than that does not overrule it
    std::optional<SecondLook> agreeing_witness(const Ball& proven, const std::string& but, const Ball& fault) const
    {
        for (const Look& other : plan_.witnesses) {
            if (other.name == but) continue;
            try {
                const Witness seen = other.witness({witness_wants_});
                if (!certainly(less(witness_error_factor * seen.error, fault))) continue;
                if (SecondLook look = held_against(proven, other.name, seen); look.agrees) return look;
            }
            catch (const BeyondReach&) { // it has nothing to say here
            }
        }
        return std::nullopt;
    }

    const Quantity& q_;
    const Plan& plan_;
    const std::optional<Exact>& exact_;
    const EvaluationOptions& options_;
    bool dear_; ///< no digits are computed for the sake of binary64: they would take too long, or are beyond reach
    long witness_wants_; ///< digits
    bool own_threads_;
    std::optional<std::future<Witness>> witness_;
    std::optional<Ball> decided_first_; ///< of a dear first proof that decided the digits: only the others are asked for more
    std::vector<Ball> balls_; ///< of the last accuracy, of the proofs that were asked for all digits; the first alone if it decided nothing
    std::optional<long> looked_again_; ///< digits that the second proof was asked for
    std::optional<Rational> point_;
    bool decided_ = false;
    std::string reason_; ///< why fewer digits than asked for are tried
};

/// There is no proof, for the reason in e.note: what the witnesses agree on, if there are any.
void estimate(const Plan& plan, long digits, Evaluation& e)
{
    if (plan.witnesses.size() < 2) return;
    std::vector<Witness> found;
    const WorkingPrecision precision(256);
    try {
        for (const Look& look : plan.witnesses) found.push_back(look.witness({most_estimated_digits}));
    }
    catch (const BeyondReach& reason) {
        if (e.note != reason.what()) e.note += fmt::format("; no estimate: {}", reason.what());
        return;
    }
    Ball hull = found.front().value, wide(0);
    for (const Witness& f : found) {
        const Ball off = abs(f.value - found.front().value);
        for (const Ball& b : {off, f.error})
            if (certainly(less(wide, b))) wide = b;
        arb_union(hull.get(), hull.get(), f.value.get(), WorkingPrecision::bits());
    }
    arb_add_error(hull.get(), Ball(8 * wide).get()); // believed, not proven: this ball only leaves as e.ball with e.proven false
    e.ball = hull;
    e.routes.clear();
    for (const Look& look : plan.witnesses) e.routes.push_back(look.name);

    const long asked = digits;
    digits = std::min(digits, most_estimated_digits);
    auto decimal = round_to_digits(hull, digits);
    const bool next_to_tie = !decimal && digits > 1 && round_to_digits(hull, digits - 1); // one digit fewer
    if (next_to_tie && asked <= most_estimated_digits) decimal = round_to_digits(hull, --digits);
    if (decimal && asked <= most_estimated_digits) {
        e.value = decimal->text();
        e.error_bound = decimal->half_unit();
        e.digits = digits;
        e.binary64 = nearest_double(hull);
        e.status = Status::estimated;
        e.note = fmt::format("no proof: two discretisations agree{}", next_to_tie ? ", to all digits but the last asked for" : "");
        return;
    }
    show_what_is_known(e, {hull}, digits, digits);
    if (e.digits == 0) e.note = "no proof: two discretisations do not agree";
    else if (e.digits < digits) e.note = fmt::format("no proof: two discretisations agree to {} digits only", e.digits);
    else e.note = "no proof: two discretisations agree";
    if (asked > most_estimated_digits) e.note += fmt::format("; at most {} digits are estimated", most_estimated_digits);
}

} // namespace

std::string_view to_string(Status s)
{
    switch (s) {
    case Status::exact: return "exact";
    case Status::certified: return "certified";
    case Status::estimated: return "estimated";
    case Status::undecided: break;
    }
    return "undecided";
}

Evaluation evaluate(const Quantity& q, const Inputs& in, const EvaluationOptions& options)
{
    release_caches_with_thread(); // the thread may be one of the caller's, who never heard of FLINT
    if (options.digits < 1 || options.digits > any_digits)
        throw DomainError(fmt::format("digits = {}: must be from 1 to {}", options.digits, any_digits));
    q.check(in);

    const auto exact = exact_result(q, in);
    if (exact && exact->is_rational()) return from_rational(exact->rational(), options.digits, {"exact-arithmetic"});

    Evaluation e;
    e.ball = Ball::indeterminate();
    show_what_is_known(e, {e.ball}, 0, 0);
    const Plan plan = plan_of(q, in, {options.digits});
    for (const Proof& p : plan.proofs) e.routes.push_back(p.name);
    if (plan.proofs.empty()) e.note = plan.refusal;
    else if (Search(q, plan, exact, options).prove(e)) return e;
    estimate(plan, options.digits, e);
    return e;
}

} // namespace touchstone
