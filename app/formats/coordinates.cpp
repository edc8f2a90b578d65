// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/coordinates.h"

#include "app/base/number.h"

#include <limits>

namespace app {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr clipping::Window everything{{-endless, -endless}, {endless, endless}};

void append(std::string& text, double value, int axis, int precision,
            const clipping::Window& bounds)
{
    if (precision < 0)
        appendNumber(text, value);
    else
        appendNumber(text, value, precision, bounds.min[axis], bounds.max[axis]);
}

double roundedCoordinate(double value, int axis, int precision, const clipping::Window& bounds)
{
    std::string text;
    append(text, value, axis, precision, bounds);
    return parseNumber(text).value_or(value);
}

} // namespace

bool becomesPoint(const clipping::Segment& line, const WriteOptions& options)
{
    return options.precision >= 0 && line.a != line.b
           && roundedPoint(line.a, options) == roundedPoint(line.b, options);
}

Point roundedPoint(const Point& point, const WriteOptions& options)
{
    const clipping::Window bounds = options.bounds.value_or(everything);
    return {roundedCoordinate(point.x, 0, options.precision, bounds),
            roundedCoordinate(point.y, 1, options.precision, bounds)};
}

Point roundedControl(const Point& point, const WriteOptions& options)
{
    return {roundedCoordinate(point.x, 0, options.precision, everything),
            roundedCoordinate(point.y, 1, options.precision, everything)};
}

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

QString rectangleText(const clipping::Window& rectangle)
{
    const auto& [min, max] = rectangle;
    std::string text;
    for (const double number : {min.x, min.y, max.x, max.y}) {
        if (!text.empty())
            text += ',';
        appendNumber(text, number);
    }
    return QString::fromStdString(text);
}

} // namespace app
