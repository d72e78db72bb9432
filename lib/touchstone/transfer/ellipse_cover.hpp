// SPDX-License-Identifier: MIT
/// \file
/// Equal rectangles that cover the upper half of the ellipse with foci +-1 and semiaxes (rho +- 1/rho)/2: a function is bounded
/// on it by its bounds on discs about them.
///
/// Internal to transfer/.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace touchstone::transfer {

struct EllipseCover {
    double half_width, half_height; ///< of each rectangle
    std::vector<std::complex<double>> middles;

    /// A rectangle is left out if its point next to 0 is outside of the ellipse, by more than roundings.
    EllipseCover(double rho, int columns, int rows)
    {
        constexpr double outside = 1.001;
        const double wide = (rho + 1 / rho) / 2, high = (rho - 1 / rho) / 2;
        half_width = wide / columns;
        half_height = high / (2 * rows);
        for (int i = 0; i < columns; ++i)
            for (int k = 0; k < rows; ++k) {
                const std::complex<double> middle((2 * i + 1) * half_width - wide, (2 * k + 1) * half_height);
                const double x = std::max(0.0, std::fabs(middle.real()) - half_width) / wide, y = (middle.imag() - half_height) / high;
                if (x * x + y * y <= outside) middles.push_back(middle);
            }
    }
};

} // namespace touchstone::transfer
