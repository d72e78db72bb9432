// SPDX-License-Identifier: MIT
#include "touchstone/scalar/exact_text.hpp"

#include <cctype>

namespace touchstone {
namespace {

struct NoExpression {};

/// Recursive descent over
///
///     product = ["-" | "+"] power {("*" | "/") power}
///     power   = base ["^" exponent]        exponent = ["-" | "+"] power (so that 2^3^2 = 2^9)
///     base    = number | "(" product ")" | "sqrt(" product ")"
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    Exact whole()
    {
        Exact value = product();
        if (peek() != '\0') throw NoExpression();
        return value;
    }

private:
    static constexpr int deepest = 50; ///< nested brackets and powers, so that no text exhausts the stack

    char peek()
    {
        while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
        return rest_.empty() ? '\0' : rest_.front();
    }
    bool take(char c)
    {
        if (peek() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    bool negative_sign()
    {
        const bool negative = take('-');
        if (!negative) take('+');
        return negative;
    }
    Exact product()
    {
        const bool negative = negative_sign();
        Exact value = power();
        for (;;) {
            if (take('*')) value = value * power();
            else if (take('/')) value = value / power();
            else return negative ? -value : value;
        }
    }
    Exact power()
    {
        if (++depth_ > deepest) throw NoExpression();
        Exact value = base();
        if (take('^')) {
            const bool negative = negative_sign();
            const Exact exponent = power();
            if (value.sign() == 0 && exponent.sign() == 0) throw NotExact(); // 0^0 is no number that all agree on
            value = pow(value, negative ? -exponent : exponent);
        }
        --depth_;
        return value;
    }
    Exact bracketed()
    {
        Exact value = product();
        if (!take(')')) throw NoExpression();
        return value;
    }
    Exact base()
    {
        if (take('(')) return bracketed();
        if (rest_.starts_with("sqrt(")) {
            rest_.remove_prefix(5);
            return sqrt(bracketed());
        }
        return number();
    }
    /// The longest run of characters that a number can be made of: exponents carry a sign.
    Exact number()
    {
        const bool hex = rest_.starts_with("0x") || rest_.starts_with("0X");
        std::size_t n = 0;
        while (n < rest_.size()) {
            const char c = rest_[n];
            const bool exponent_sign =
                (c == '-' || c == '+') && n > 0 && std::string_view(hex ? "pP" : "eE").find(rest_[n - 1]) != std::string_view::npos;
            if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && !exponent_sign) break;
            ++n;
        }
        const auto value = parse_rational(rest_.substr(0, n));
        if (!value) throw NoExpression();
        rest_.remove_prefix(n);
        return Exact(*value);
    }

    std::string_view rest_;
    int depth_ = 0;
};

} // namespace

Root as_root(const Exact& x)
{
    if (x.is_rational()) return {x.rational(), 1};
    if (x.sign() < 0) throw NotExact();
    // x^d = r^d s^(d/m) is rational only if m divides d: s is no perfect p-th power for a prime p that divides m
    return {x.power(Rational(x.degree())).rational(), x.degree()};
}

std::optional<Exact> parse_exact(std::string_view text)
{
    if (const auto r = parse_rational(text)) return Exact(*r);
    try {
        return Reader(text).whole();
    }
    catch (const NoExpression&) {
        return std::nullopt;
    }
    catch (const NotExact&) {
        return std::nullopt;
    }
}

} // namespace touchstone
