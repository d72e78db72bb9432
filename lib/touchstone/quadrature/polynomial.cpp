// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/polynomial.hpp"

#include "touchstone/quadrature/exact_series.hpp"

namespace touchstone::quadrature {
namespace {

constexpr std::size_t most_terms = 33;

using Maybe = std::optional<Polynomial>;

Polynomial trimmed(Polynomial p)
{
    while (!p.empty() && p.back().is_zero()) p.pop_back();
    return p;
}

Polynomial sum(const Polynomial& a, const Polynomial& b)
{
    Polynomial r(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < a.size(); ++i) r[i] = a[i];
    for (std::size_t i = 0; i < b.size(); ++i) r[i] = r[i] + b[i];
    return trimmed(std::move(r));
}

Maybe product(const Polynomial& a, const Polynomial& b)
{
    if (a.empty() || b.empty()) return Polynomial{};
    if (a.size() + b.size() - 1 > most_terms) return std::nullopt;
    Polynomial r(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (!a[i].is_zero() && !b[j].is_zero()) r[i + j] = r[i + j] + a[i] * b[j]; // most are 0
    return trimmed(std::move(r));
}

} // namespace

Maybe polynomial(const Expression& e)
{
    if (!depends_on_x(e)) {
        const auto c = exact_value(e);
        return c ? Maybe(trimmed({*c})) : std::nullopt;
    }
    switch (e.op) {
    case Op::variable: return Polynomial{ExactSum(0), ExactSum(1)};
    case Op::negate: {
        const auto a = polynomial(*e.args[0]);
        return a ? product(*a, {ExactSum(-1)}) : std::nullopt;
    }
    case Op::add:
    case Op::multiply: {
        const auto a = polynomial(*e.args[0]), b = polynomial(*e.args[1]);
        if (!a || !b) return std::nullopt;
        return e.op == Op::add ? Maybe(sum(*a, *b)) : product(*a, *b);
    }
    case Op::divide: {
        const auto b = exact_value(*e.args[1]);
        const auto inverse = b ? b->inverse() : std::nullopt;
        const auto a = inverse ? polynomial(*e.args[0]) : std::nullopt;
        return a ? product(*a, {*inverse}) : std::nullopt;
    }
    case Op::power: {
        const auto n = exact_value(*e.args[1]);
        const auto q = n ? n->rational() : std::nullopt;
        if (!q || q.value().get_den() != 1 || *q < 1 || *q >= static_cast<long>(most_terms)) return std::nullopt;
        const auto a = polynomial(*e.args[0]);
        if (!a) return std::nullopt;
        Polynomial r = *a;
        for (long k = 1; k < q->get_num().get_si(); ++k) {
            auto next = product(r, *a);
            if (!next) return std::nullopt;
            r = std::move(*next);
        }
        return r;
    }
    default: return std::nullopt;
    }
}

ExactSum value(const Polynomial& p, const ExactSum& x)
{
    ExactSum r;
    for (auto c = p.rbegin(); c != p.rend(); ++c) r = r * x + *c;
    return r;
}

Polynomial without_root(const Polynomial& p, const ExactSum& root)
{
    if (p.size() < 2) return {};
    Polynomial q(p.size() - 1);
    ExactSum carry;
    for (std::size_t i = p.size() - 1; i-- > 0;) {
        carry = carry * root + p[i + 1];
        q[i] = carry;
    }
    return trimmed(std::move(q));
}

} // namespace touchstone::quadrature
