// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/coordinates.h"

#include "app/base/number.h"

#include <limits>

namespace app {
namespace {

constexpr double all = std::numeric_limits<double>::infinity();
constexpr clipping::Window everything{{-all, -all}, {all, all}};

void append(std::string& text, double value, int axis, int precision,
            const clipping::Window& bounds)
{
    if (precision < 0)
        appendNumber(text, value);
    else
        appendNumber(text, value, precision, bounds.min[axis], bounds.max[axis]);
}

} // namespace

void appendCoordinate(std::string& text, double value, int axis, const WriteOptions& options)
{
    append(text, value, axis, options.precision, options.bounds.value_or(everything));
}

void appendPoint(std::string& text, const Point& point, char between, const WriteOptions& options)
{
    appendCoordinate(text, point.x, 0, options);
    text += between;
    appendCoordinate(text, point.y, 1, options);
}

void appendControl(std::string& text, const Point& point, char between, const WriteOptions& options)
{
    append(text, point.x, 0, options.precision, everything);
    text += between;
    append(text, point.y, 1, options.precision, everything);
}

} // namespace app
