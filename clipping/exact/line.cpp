// SPDX-License-Identifier: MIT
#include "clipping/exact/line.h"

#include "clipping/exact/quotient.h"
#include "clipping/ieee_numbers.h"

namespace clipping {
std::strong_ordering orderInIntegers(double ax, double ay, double bx, double by, double x, double y)
{
    const int unit = commonExponent({ax, ay, bx, by, x, y});
    const auto whole = [unit](double value) { return ExactInteger(value, unit); };
    const ExactInteger width = whole(bx) - whole(ax), height = whole(by) - whole(ay);
    const ExactInteger p = (whole(x) - whole(ax)) * height, q = (whole(y) - whole(ay)) * width;
    return (p - q).sign() * width.sign() * height.sign() <=> 0;
}

template <class T>
double crossingInIntegers(double ax, double ay, double bx, double by, double x)
{
    const int unit = commonExponent({ax, ay, bx, by, x});
    const auto whole = [unit](double value) { return ExactInteger(value, unit); };
    const ExactInteger width = whole(bx) - whole(ax);
    const ExactInteger numerator =
        whole(ay) * width + (whole(by) - whole(ay)) * (whole(x) - whole(ax));
    return nearestQuotient<T>(numerator, width, unit);
}

template double crossingInIntegers<double>(double, double, double, double, double);
template double crossingInIntegers<float>(double, double, double, double, double);

} // namespace clipping
