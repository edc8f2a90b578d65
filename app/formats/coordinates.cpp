// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/coordinates.h"

#include "app/formats/number.h"

#include <limits>

namespace app {
namespace {

constexpr double all = std::numeric_limits<double>::infinity();
constexpr clipping::Window everything{{-all, -all}, {all, all}};

void append(std::string& text, const Point& point, char between, int precision,
            const clipping::Window& bounds)
{
    for (const int axis : {0, 1}) {
        if (axis == 1)
            text += between;
        if (precision < 0)
            appendNumber(text, point[axis]);
        else
            appendNumber(text, point[axis], precision, bounds.min[axis], bounds.max[axis]);
    }
}

} // namespace

void appendPoint(std::string& text, const Point& point, char between, const WriteOptions& options)
{
    append(text, point, between, options.precision, options.bounds.value_or(everything));
}

void appendControl(std::string& text, const Point& point, char between, const WriteOptions& options)
{
    append(text, point, between, options.precision, everything);
}

} // namespace app
