// SPDX-License-Identifier: MIT
#include "base/trig.hpp"

#include <cmath>

namespace posepack::base {
namespace {

// Taylor series in Horner form. On |x| <= pi/4 the first term left out is below 1e-19.
double sine_kernel(double x) {
    const double z = x * x;
    double s = 1.0 / 355687428096000.0;  // 1/17!
    s = s * z - 1.0 / 1307674368000.0;   // 1/15!
    s = s * z + 1.0 / 6227020800.0;
    s = s * z - 1.0 / 39916800.0;
    s = s * z + 1.0 / 362880.0;
    s = s * z - 1.0 / 5040.0;
    s = s * z + 1.0 / 120.0;
    s = s * z - 1.0 / 6.0;
    return x + x * z * s;
}

double cosine_kernel(double x) {
    const double z = x * x;
    double c = 1.0 / 20922789888000.0;  // 1/16!
    c = c * z - 1.0 / 87178291200.0;
    c = c * z + 1.0 / 479001600.0;
    c = c * z - 1.0 / 3628800.0;
    c = c * z + 1.0 / 40320.0;
    c = c * z - 1.0 / 720.0;
    c = c * z + 1.0 / 24.0;
    c = c * z - 1.0 / 2.0;
    return 1.0 + z * c;
}

// Splits x into quadrant * pi/2 + remainder with |remainder| <= pi/4. Pi/2 in two parts (Cody and Waite,
// Software Manual for the Elementary Functions, 1980): the first has 20 trailing zero bits, so
// that quadrant * part is exact for |quadrant| < 2^20.
double reduce(double x, long* quadrant) {
    constexpr double kHalfPiHigh = 1.57079632673412561417;  // 33 significant bits
    constexpr double kHalfPiLow = 6.07710050650619224932e-11;
    const double q = std::floor(x / (kPi / 2) + 0.5);
    *quadrant = static_cast<long>(q);
    return (x - q * kHalfPiHigh) - q * kHalfPiLow;
}

double by_quadrant(double r, long quadrant) {
    switch (quadrant & 3) {
        case 0:
            return sine_kernel(r);
        case 1:
            return cosine_kernel(r);
        case 2:
            return -sine_kernel(r);
        default:
            return -cosine_kernel(r);
    }
}

}  // namespace

double sine(double x) {
    long quadrant = 0;
    const double r = reduce(x, &quadrant);
    return by_quadrant(r, quadrant);
}

double cosine(double x) {
    long quadrant = 0;
    const double r = reduce(x, &quadrant);
    return by_quadrant(r, quadrant + 1);
}

double arc_tangent_unit(double x) {
    // atan(x) = atan(c) + atan((x - c) / (1 + c x)) with c in {0, tan(pi/8), 1}: |argument| <= tan(pi/16).
    constexpr double kTanPi16 = 0.19891236737965800691;
    constexpr double kTanPi8 = 0.41421356237309504880;
    constexpr double kTan3Pi16 = 0.66817863791929891999;
    double base = 0.0;
    double y = x;
    if (x > kTan3Pi16) {
        base = kPi / 4;
        y = (x - 1.0) / (1.0 + x);
    } else if (x > kTanPi16) {
        base = kPi / 8;
        y = (x - kTanPi8) / (1.0 + kTanPi8 * x);
    }
    // Taylor series; the first term left out is below 2e-18.
    const double z = y * y;
    double s = 1.0 / 21.0;
    s = 1.0 / 19.0 - z * s;
    s = 1.0 / 17.0 - z * s;
    s = 1.0 / 15.0 - z * s;
    s = 1.0 / 13.0 - z * s;
    s = 1.0 / 11.0 - z * s;
    s = 1.0 / 9.0 - z * s;
    s = 1.0 / 7.0 - z * s;
    s = 1.0 / 5.0 - z * s;
    s = 1.0 / 3.0 - z * s;
    return base + (y - y * z * s);
}

double arc_tangent(double x) {
    return x <= 1.0 ? arc_tangent_unit(x) : kPi / 2 - arc_tangent_unit(1.0 / x);
}

}  // namespace posepack::base
