// SPDX-License-Identifier: MIT
/// \file
/// GMRES in binary64. A search: nothing here is trusted. Internal to limit/.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace touchstone::limit {

using Vector = std::vector<double>;

inline double dot(const Vector& a, const Vector& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}
inline void add(Vector& to, double factor, const Vector& v)
{
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * v[i];
}

/// The Hessenberg matrix of Arnoldi's process, made triangular by rotations as it grows.
class Triangle {
public:
    explicit Triangle(double first) : right{first} {}
    /// h: the next column, one longer than the last
    void add_column(Vector h)
    {
        for (std::size_t k = 0; k < rotations.size(); ++k) rotate(h[k], h[k + 1], rotations[k]);
        const std::size_t k = rotations.size();
        const double r = std::hypot(h[k], h[k + 1]);
        rotations.emplace_back(h[k] / r, h[k + 1] / r);
        h[k] = r;
        h.pop_back();
        right.push_back(0);
        rotate(right[k], right[k + 1], rotations.back());
        columns.push_back(std::move(h));
    }
    double residual() const { return std::fabs(right.back()); }
    Vector solution() const
    {
        Vector y(columns.size());
        for (std::size_t k = y.size(); k-- > 0;) {
            double sum = right[k];
            for (std::size_t j = k + 1; j < y.size(); ++j) sum -= columns[j][k] * y[j];
            y[k] = sum / columns[k][k];
        }
        return y;
    }

private:
    static void rotate(double& a, double& b, const std::pair<double, double>& by)
    {
        const double old = a;
        a = by.first * a + by.second * b;
        b = by.first * b - by.second * old;
    }
    std::vector<Vector> columns;
    std::vector<std::pair<double, double>> rotations; // cosine, sine
    Vector right;                                     // last: the residual
};

/// v with A v near `right`, until that is off by `relative` of it or so many steps are done.
template <class Apply>
Vector gmres(const Apply& A, const Vector& right, double relative, int most_steps)
{
    const double size = std::sqrt(dot(right, right));
    Vector v(right.size());
    if (!(size > 0)) return v;
    std::vector<Vector> basis{Vector(right.size())};
    add(basis[0], 1 / size, right);
    Triangle triangle(size);
    for (int k = 0; k < most_steps && triangle.residual() > relative * size; ++k) {
        Vector next = A(basis.back()), h(basis.size());
        for (const int again : {0, 1}) { // twice is enough (Kahan, Parlett)
            static_cast<void>(again);
            for (std::size_t j = 0; j < basis.size(); ++j) {
                const double along = dot(next, basis[j]);
                h[j] += along;
                add(next, -along, basis[j]);
            }
        }
        h.push_back(std::sqrt(dot(next, next)));
        const double length = h.back();
        triangle.add_column(std::move(h));
        if (!(length > 0)) break;
        basis.emplace_back(right.size());
        add(basis.back(), 1 / length, next);
    }
    const Vector y = triangle.solution();
    for (std::size_t k = 0; k < y.size(); ++k) add(v, y[k], basis[k]);
    return v;
}

} // namespace touchstone::limit
