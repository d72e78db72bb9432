// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Many changes of a source in one compilation, one of them switched on at run time: what mutate_sources.py and mutate_library.py write
/// into a copy of a source.
///
///     a + b  ->  a + mutant::Sign{17} * b          times -1 if change 17 is on, or 0 - b where b has no sign to change
///     a * b  ->  a * (mutant::Inverse{18} ->* b)   divided by b if change 18 is on; ->* binds tighter than *
///     3      ->  mutant::number(19, 3)             4 if change 19 is on
///     a < b  ->  a < mutant::Compared{20} < b      a <= b if change 20 is on: both are read from the left, and bind as the one did
///     a && b ->  (bool(a) != mutant::on(21) ? bool(b) : mutant::on(21))     a || b if change 21 is on
///     a || b ->  (bool(a) != mutant::on(22) ? !mutant::on(22) : bool(b))    a && b if change 22 is on
///
/// In a constant expression nothing can be switched; there the source stays what it is, and the change is not counted as reached.
#pragma once

#include <gmpxx.h>

#include <type_traits>
#include <utility>

namespace mutant {

inline constexpr int most = 80000;
extern int active;                   ///< the change that is on, -1 for none
extern unsigned char* reached;       ///< reached[i]: the program came by change i
extern unsigned char at_start[most]; ///< the same before main

constexpr bool on(int id)
{
    if (std::is_constant_evaluated()) return false;
    reached[id] = 1;
    return id == active;
}

constexpr int number(int id, int n) { return on(id) ? n + 1 : n; }

/// The type of a value: GMP's expressions are made numbers.
template <class T>
struct Value { using type = std::decay_t<T>; };
template <class T, class U>
struct Value<__gmp_expr<T, U>> { using type = __gmp_expr<T, T>; };
template <class T>
using value_t = typename Value<std::decay_t<T>>::type;

struct Sign { int id; };
template <class T>
constexpr auto operator*(Sign s, const T& x)
{
    if constexpr (requires { value_t<decltype(-x)>(x); }) {
        using V = value_t<decltype(-x)>;
        return on(s.id) ? V(-x) : V(x);
    } else if constexpr (requires { requires std::is_same_v<value_t<T>, value_t<decltype(T{} - x)>>; }) {
        using V = value_t<T>;
        return on(s.id) ? V(V{} - x) : V(x);
    } else {
        return x; // a string: its + has no -
    }
}

template <class T>
struct Factor {
    int id;
    const T& x;
};
struct Inverse { int id; };
template <class T>
constexpr Factor<T> operator->*(Inverse i, const T& x) { return {i.id, x}; }

template <class A, class T>
constexpr auto operator*(const A& a, const Factor<T>& f)
{
    using V = value_t<decltype(a * f.x)>;
    if constexpr (requires { V(a / f.x); }) return on(f.id) ? V(a / f.x) : V(a * f.x);
    else return V(a * f.x);
}
template <class A, class T>
constexpr auto operator/(const A& a, const Factor<T>& f)
{
    using V = value_t<decltype(a / f.x)>;
    if constexpr (requires { V(a * f.x); }) return on(f.id) ? V(a * f.x) : V(a / f.x);
    else return V(a / f.x);
}

/// The left side of a comparison, with the sign it had.
enum class Order { less, at_most, more, at_least };
template <Order order, class T>
struct LeftSide {
    int id;
    const T& x;
};
struct Compared { int id; };
template <class T>
constexpr LeftSide<Order::less, T> operator<(const T& x, Compared c) { return {c.id, x}; }
template <class T>
constexpr LeftSide<Order::at_most, T> operator<=(const T& x, Compared c) { return {c.id, x}; }
template <class T>
constexpr LeftSide<Order::more, T> operator>(const T& x, Compared c) { return {c.id, x}; }
template <class T>
constexpr LeftSide<Order::at_least, T> operator>=(const T& x, Compared c) { return {c.id, x}; }
template <class T, class U>
constexpr auto operator<(const LeftSide<Order::less, T>& a, const U& b) { return on(a.id) ? a.x <= b : a.x < b; }
template <class T, class U>
constexpr auto operator<=(const LeftSide<Order::at_most, T>& a, const U& b) { return on(a.id) ? a.x < b : a.x <= b; }
template <class T, class U>
constexpr auto operator>(const LeftSide<Order::more, T>& a, const U& b) { return on(a.id) ? a.x >= b : a.x > b; }
template <class T, class U>
constexpr auto operator>=(const LeftSide<Order::at_least, T>& a, const U& b) { return on(a.id) ? a.x > b : a.x >= b; }

} // namespace mutant
