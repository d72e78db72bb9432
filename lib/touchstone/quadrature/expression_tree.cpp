// SPDX-License-Identifier: MIT
// Trees of formulas: made, asked about, and their names bound.
#include "touchstone/quadrature/expression_tree.hpp"

#include <algorithm>

namespace touchstone::quadrature {

ExpressionPtr make_number(const Rational& r)
{
    Expression e;
    e.number = r;
    return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr make_variable() { return make(Op::variable, {}); }

ExpressionPtr make_ball(const ComplexBall& z)
{
    Expression e;
    e.op = Op::ball;
    e.ball = std::make_shared<const ComplexBall>(z);
    return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr make(Op op, std::vector<ExpressionPtr> args)
{
    Expression e;
    e.op = op;
    if (!args.empty()) e.column = args.front()->column;
    e.args = std::move(args);
    return std::make_shared<const Expression>(std::move(e));
}

bool any_node(const Expression& e, const std::function<bool(const Expression&)>& is)
{
    if (is(e) || (e.integrand && any_node(*e.integrand, is))) return true;
    return std::any_of(e.args.begin(), e.args.end(), [&](const ExpressionPtr& a) { return any_node(*a, is); });
}

bool depends_on_x(const Expression& e)
{
    if (e.op == Op::variable) return true;
    if (e.integrand && any_node(*e.integrand, [](const Expression& n) { return n.op == Op::outer; })) return true;
    return std::any_of(e.args.begin(), e.args.end(), [](const ExpressionPtr& a) { return depends_on_x(*a); });
}

bool has_order(Op op)
{
    switch (op) {
    case Op::bessel_j:
    case Op::bessel_y:
    case Op::bessel_i:
    case Op::bessel_k:
    case Op::bessel_i_scaled:
    case Op::bessel_k_scaled:
    case Op::polylog: return true;
    default: return false;
    }
}

bool is_real(const Expression& e)
{
    if (e.op == Op::imaginary_unit) return false;
    const bool part = e.op == Op::real_part || e.op == Op::imaginary_part || e.op == Op::real_value || e.op == Op::imaginary_value;
    if (part || e.op == Op::abs) return true;
    if (e.integrand && !is_real(*e.integrand)) return false;
    return std::all_of(e.args.begin(), e.args.end(), [](const ExpressionPtr& a) { return is_real(*a); });
}

bool has_complex_point(const Expression& e)
{
    return any_node(e, [](const Expression& n) { return n.op == Op::ball && n.ball && !acb_is_real(n.ball->get()); });
}

ExpressionPtr rebuilt(const ExpressionPtr& e, const std::function<ExpressionPtr(const ExpressionPtr&)>& leaf)
{
    if (const ExpressionPtr other = leaf(e)) return other;
    if (e->args.empty() && !e->integrand) return e;
    Expression copy = *e;
    for (ExpressionPtr& a : copy.args) a = rebuilt(a, leaf);
    if (copy.integrand) copy.integrand = rebuilt(copy.integrand, leaf);
    return std::make_shared<const Expression>(std::move(copy));
}

namespace {

/// The nodes seen so far, by what they compute from which nodes.
class Parts {
public:
    ExpressionPtr shared(const ExpressionPtr& e)
    {
        if (const auto found = done_.find(e.get()); found != done_.end()) return found->second;
        Key key{e->op, e->number.get_str(), e->radius.get_str(), e->name, e->ball.get(), nullptr, {}};
        Expression copy = *e;
        bool changed = false;
        const auto replace = [&](ExpressionPtr& part) {
            ExpressionPtr one = shared(part);
            changed = changed || one != part;
            part = std::move(one);
        };
        for (ExpressionPtr& a : copy.args) {
            replace(a);
            key.args.push_back(a.get());
        }
        if (copy.integrand) {
            replace(copy.integrand);
            key.integrand = copy.integrand.get();
        }
        auto& known = known_[std::move(key)];
        if (!known) known = changed ? std::make_shared<const Expression>(std::move(copy)) : e;
        done_[e.get()] = known;
        return known;
    }

private:
    struct Key {
        Op op;
        std::string number, radius, name;
        const ComplexBall* ball;
        const Expression* integrand;
        std::vector<const Expression*> args;
        auto operator<=>(const Key&) const = default;
    };
    std::map<Key, ExpressionPtr> known_;
    std::map<const Expression*, ExpressionPtr> done_; // of the tree that is walked, which its owner keeps
};

} // namespace

ExpressionPtr with_shared_parts(const ExpressionPtr& e) { return Parts().shared(e); }

namespace {

class Names {
public:
    explicit Names(const Parameters& parameters)
        : parameters_(parameters)
    {
    }
    ExpressionPtr bound(const ExpressionPtr& e) const
    {
        if (e->op == Op::integral) return inner(*e);
        if (e->op == Op::infinity) throw ExpressionError(e->column, "inf is no number: it may only be an end");
        if (e->op == Op::parameter) return parameter(*e);
        if (e->op == Op::variable && !own_.empty()) return make(Op::outer, {});
        if (e->args.empty()) return e;
        Expression copy = *e;
        for (ExpressionPtr& a : copy.args) a = bound(a);
        if (copy.op == Op::polylog && copy.args[0]->op == Op::number && copy.args[0]->number == 0) return without_order(copy);
        return std::make_shared<const Expression>(std::move(copy));
    }

private:
    /// The polylogarithm of order 0 is x/(1 - x): it has a pole where the others have a cut.
    static ExpressionPtr without_order(const Expression& polylogarithm)
    {
        const ExpressionPtr& x = polylogarithm.args[1];
        Expression quotient = *make(Op::divide, {x, make(Op::add, {make_number(1), make(Op::negate, {x})})});
        quotient.column = polylogarithm.column;
        return std::make_shared<const Expression>(std::move(quotient));
    }
    ExpressionPtr parameter(const Expression& e) const
    {
        if (!own_.empty() && e.name == own_) return make_variable();
        const auto found = parameters_.find(e.name);
        if (found == parameters_.end())
            throw ExpressionError(e.column, "'" + e.name + "' is not known: the variable is x, the constants are pi, e and i" +
                                                (parameters_.empty() ? "" : ", the parameters those that were set"));
        if (found->second.radius == 0) return make_number(found->second.middle);
        Expression b;
        b.op = Op::ball;
        b.column = e.column;
        b.number = found->second.middle;
        b.radius = found->second.radius;
        return std::make_shared<const Expression>(std::move(b));
    }
    /// An end: an infinite one stays what it is.
    ExpressionPtr end(const ExpressionPtr& e) const
    {
        const bool infinite = e->op == Op::infinity || (e->op == Op::negate && e->args[0]->op == Op::infinity);
        return infinite ? e : bound(e);
    }
    ExpressionPtr inner(const Expression& e) const
    {
        if (!own_.empty()) throw ExpressionError(e.column, "an integral inside an inner integral: two levels is the most");
        const Expression& name = *e.args[1];
        if (name.op != Op::parameter || parameters_.contains(name.name))
            throw ExpressionError(name.column, "integral(f, y, a, b) needs a name of its own for its variable, neither x nor a parameter");
        Names inside(parameters_);
        inside.own_ = name.name;
        Expression r;
        r.op = Op::integral;
        r.column = e.column;
        r.integrand = inside.bound(e.args[0]);
        r.args = {end(e.args[2]), end(e.args[3])};
        return std::make_shared<const Expression>(std::move(r));
    }

    const Parameters& parameters_;
    std::string own_; // inside an integral, its variable
};

} // namespace

ExpressionPtr with_names_bound(const ExpressionPtr& e, const Parameters& parameters) { return Names(parameters).bound(e); }

namespace tree {
namespace {

void add_summands(const ExpressionPtr& e, bool negated, std::vector<ExpressionPtr>& out)
{
    if (e->op == Op::add)
        for (const ExpressionPtr& a : e->args) add_summands(a, negated, out);
    else if (e->op == Op::negate)
        add_summands(e->args[0], !negated, out);
    else
        out.push_back(negated ? of(Op::negate, e) : e);
}

/// The number, with its sign.
std::optional<Rational> number_of(const Expression& e)
{
    if (e.op == Op::number) return e.number;
    return e.op == Op::negate && e.args[0]->op == Op::number ? std::optional(Rational(-e.args[0]->number)) : std::nullopt;
}

} // namespace

std::vector<ExpressionPtr> summands(const ExpressionPtr& e)
{
    std::vector<ExpressionPtr> all;
    add_summands(e, false, all);
    return all;
}

ExpressionPtr sum_of(const std::vector<ExpressionPtr>& all)
{
    if (all.empty()) return number(0);
    ExpressionPtr r = all.front();
    for (std::size_t i = 1; i < all.size(); ++i) r = sum(r, all[i]);
    return r;
}

ExpressionPtr with_numbers_collected(const ExpressionPtr& e)
{
    if (e->op != Op::add) return e;
    Rational total = 0;
    std::size_t numbers = 0;
    std::vector<ExpressionPtr> others;
    for (const ExpressionPtr& a : summands(e))
        if (const auto q = number_of(*a)) {
            total += *q;
            ++numbers;
        }
        else
            others.push_back(a);
    if (numbers < 2) return e;
    if (total != 0) others.insert(others.begin(), make_number(total));
    return sum_of(others);
}

} // namespace tree

} // namespace touchstone::quadrature
