// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"

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

/// The other routes' balls: computed on threads of their own beside the first route where that pays
/// (many digits), on demand where it does not.
class OtherRoutes {
public:
    OtherRoutes(const Quantity& q, const Inputs& in, bool at_once)
    {
        const auto policy = at_once ? std::launch::async : std::launch::deferred;
        for (std::size_t i = 1; i < q.routes.size(); ++i)
            balls_.push_back(std::async(policy, [&route = q.routes[i], &in, at_once, bits = WorkingPrecision::bits()] {
                const WorkingPrecision precision(bits);
                Ball b = route.ball(in);
                if (at_once) flint_cleanup(); // the thread's caches of constants end with it
                return b;
            }));
    }
    Ball get(std::size_t route) { return balls_[route - 1].get(); }

private:
    std::vector<std::future<Ball>> balls_;
};

/// As many digits as the ball decides, up to `digits`; may be none.
void show_what_is_known(Evaluation& e, long digits)
{
    for (long n = digits; n >= 1; --n)
        if (const auto d = round_to_digits(e.ball, n)) {
            e.value = d->text(digits);
            e.error_bound = d->half_unit();
            e.digits = n;
            return;
        }
    e.value = "nan";
    e.error_bound = "inf";
    e.digits = 0;
}

/// The certified routes refused, for the reason in e.note: what the estimates agree on, if there are any.
void estimate(const Quantity& q, const Inputs& in, long digits, Evaluation& e)
{
    std::vector<Estimate> found;
    const WorkingPrecision precision(256);
    try {
        std::vector<std::future<Estimate>> running;
        for (const EstimateRoute& r : q.estimates) running.push_back(std::async(std::launch::deferred, [&] { return r.estimate(in); }));
        for (auto& f : running) found.push_back(f.get());
    }
    catch (const BeyondReach& reason) {
        if (e.note != reason.what()) e.note += fmt::format("; no estimate: {}", reason.what());
        return;
    }
    if (found.empty()) return;
    Ball hull = found.front().value, wide(0);
    for (const Estimate& f : found) {
        const Ball off = abs(f.value - found.front().value);
        for (const Ball& b : {off, f.error})
            if (certainly(less(wide, b))) wide = b;
        arb_union(hull.get(), hull.get(), f.value.get(), WorkingPrecision::bits());
    }
    arb_add_error(hull.get(), Ball(8 * wide).get());
    e.ball = hull;
    e.routes.clear();
    for (const EstimateRoute& r : q.estimates) e.routes.push_back(r.name);
    auto decimal = round_to_digits(hull, std::min(digits, most_estimated_digits));
    const auto agreed = [&](long n) { return n < 1 ? std::string("no proof: two discretisations do not agree") : fmt::format("no proof: two discretisations agree to {} digits only", n); };
    if (digits > most_estimated_digits) {
        long n = most_estimated_digits;
        while (n > 0 && !round_to_digits(hull, n)) --n;
        e.note = (n == most_estimated_digits ? "no proof: two discretisations agree" : agreed(n)) + fmt::format("; at most {} digits are estimated", most_estimated_digits);
        return;
    }
    e.note = "no proof: two discretisations agree";
    if (!decimal && digits > 1) { // next to a tie of the last digit: one digit fewer
        decimal = round_to_digits(hull, --digits);
        if (decimal) e.note += ", to all digits but the last asked for";
    }
    if (!decimal) {
        while (digits > 0 && !round_to_digits(hull, digits)) --digits;
        e.note = agreed(digits);
        return;
    }
    e.value = decimal->text();
    e.error_bound = decimal->half_unit();
    e.digits = digits;
    e.binary64 = nearest_double(hull);
    e.status = Status::estimated;
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
    if (options.digits < 1 || options.digits > 10'000)
        throw DomainError(fmt::format("digits = {}: must be from 1 to 10000", options.digits));
    q.check(in);

    const auto exact = exact_result(q, in);
    if (exact && exact->is_rational()) return from_rational(exact->rational(), options.digits, {"exact-arithmetic"});

    Evaluation e;
    e.ball = Ball::indeterminate();
    long shown = options.digits; // digits of an undecided value
    if (q.route_names) e.routes = q.route_names(in);
    else for (const auto& r : q.routes) e.routes.push_back(r.name);
    const Quantity::Limits limits = q.limits ? q.limits(in) : Quantity::Limits{};
    const slong natural = bits_for_digits(options.digits) + 48;
    const slong limit = options.limit_bits > 0 ? options.limit_bits : 16 * natural + 8192;
    // The last precision tried is always `limit`, whatever the first was: what is decided does not depend on the start.
    const slong start = std::min(options.start_bits > 0 ? options.start_bits : natural, limit);
    for (slong bits = start, tried = 0; tried < limit; tried = bits, bits = std::min(2 * bits, limit)) {
        const WorkingPrecision precision(bits);
        try {
            e.bits = bits;
            if (options.digits > limits.digits) throw BeyondReach(fmt::format("certified to at most {} digits here", limits.digits));
            OtherRoutes others(q, in, q.costly || options.digits >= 300);
            e.ball = q.routes.front().ball(in);
            const auto point = exact_value(e.ball); // radius zero: the value itself, which the other routes must contain
            const auto decimal = round_to_digits(e.ball, options.digits);
            if (!point && !decimal) continue;
            bool agreed = true;
            for (std::size_t i = 1; i < q.routes.size() && agreed; ++i) {
                const Ball other = others.get(i);
                if (!other.overlaps(e.ball))
                    throw RoutesDisagree(fmt::format("{}: routes '{}' and '{}' give disjoint balls {} and {}", q.name,
                                                     q.routes[0].name, q.routes[i].name, e.ball.to_string(), other.to_string()));
                agreed = point || limits.first_decides || round_to_digits(other, options.digits) == decimal; // each alone decides the digits
            }
            if (point) return from_rational(*point, options.digits, e.routes);
            if (exact && !exact->ball().overlaps(e.ball))
                throw RoutesDisagree(fmt::format("{}: ball {} misses the exact value", q.name, e.ball.to_string()));
            if (!agreed) continue;
            e.binary64 = nearest_double(e.ball);
            if (!e.binary64 && !limits.first_decides && bits < limit) continue; // there it costs too much where it was not asked for
            e.value = decimal->text();
            e.error_bound = decimal->half_unit();
            e.digits = options.digits;
            e.status = Status::certified;
            return e;
        }
        catch (const BeyondReach& reason) {
            e.note = reason.what();
            estimate(q, in, options.digits, e);
            if (e.status == Status::estimated) return e;
            if (!q.estimates.empty()) shown = std::min(shown, most_estimated_digits);
            break;
        }
    }
    if (e.note.empty() && limits.first_decides) e.note = "no more digits are certified here";
    if (e.note.empty()) e.note = fmt::format("not decided at {} bits; a larger --max-precision may", e.bits);
    e.status = Status::undecided;
    show_what_is_known(e, shown);
    return e;
}

} // namespace touchstone
