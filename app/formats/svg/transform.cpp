// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/transform.h"

#include "app/document/path.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace app::svg {
namespace {

using Arguments = std::span<const double>;

// Sine that is exact at quarter turns, so that rotate(90) keeps round coordinates.
double sine(double degrees)
{
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0 || std::abs(turn) == 180)
        return 0;
    if (std::abs(turn) == 90)
        return turn > 0 ? 1 : -1;
    return std::sin(turn * std::numbers::pi / 180);
}
double cosine(double degrees) { return sine(degrees + 90); }
double tangent(double degrees) { return sine(degrees) / cosine(degrees); }

Matrix rotationMatrix(Arguments v)
{
    const double s = sine(v[0]), c = cosine(v[0]);
    return translation({v[1], v[2]}) * Matrix{c, s, -s, c, 0, 0} * translation({-v[1], -v[2]});
}

Matrix scalingMatrix(double x, double y) { return {x, 0, 0, y, 0, 0}; }

std::optional<double> asNumber(std::string_view text, const TransformUnits&)
{
    Scanner in(text);
    const auto number = in.number();
    return in.atEnd() ? number : std::nullopt;
}

std::optional<double> asFactor(std::string_view text, const TransformUnits&)
{
    Scanner in(text);
    auto number = in.number();
    if (number && in.take('%'))
        *number /= 100;
    return in.atEnd() ? number : std::nullopt;
}

std::optional<double> asAngle(std::string_view text, const TransformUnits& units)
{
    Scanner in(text);
    const auto number = in.number();
    const auto degrees = degreesOf(in.rest());
    if (!number || !degrees || (units.isCss && lacksUnit(text)))
        return std::nullopt;
    return *number * *degrees;
}

template <int axis>
std::optional<double> asLength(std::string_view text, const TransformUnits& units)
{
    return transformLength(text, units, axis);
}

struct Function {
    using Argument = std::optional<double> (*)(std::string_view, const TransformUnits&);

    std::string_view name;
    Matrix (*matrix)(Arguments v); ///< v holds six numbers; missing ones are 0
    std::size_t fewest, most;      ///< how many numbers; only these two counts are legal
    std::array<Argument, 6> arguments;
};

constexpr std::array functions{
    Function{"matrix",
             [](Arguments v) { return Matrix{v[0], v[1], v[2], v[3], v[4], v[5]}; },
             6,
             6,
             {asNumber, asNumber, asNumber, asNumber, asNumber, asNumber}},
    Function{"translate",
             [](Arguments v) {
                 return translation({v[0], v[1]});
             },
             1,
             2,
             {asLength<0>, asLength<1>}},
    Function{
        "scale", [](Arguments v) { return scalingMatrix(v[0], v[1]); }, 1, 2, {asFactor, asFactor}},
    Function{"rotate", rotationMatrix, 1, 3, {asAngle, asLength<0>, asLength<1>}},
    Function{
        "skewX", [](Arguments v) { return Matrix{1, 0, tangent(v[0]), 1, 0, 0}; }, 1, 1, {asAngle}},
    Function{
        "skewY", [](Arguments v) { return Matrix{1, tangent(v[0]), 0, 1, 0, 0}; }, 1, 1, {asAngle}},
    Function{"skew",
             [](Arguments v) { return Matrix{1, tangent(v[1]), tangent(v[0]), 1, 0, 0}; },
             1,
             2,
             {asAngle, asAngle}},
    Function{"translateX",
             [](Arguments v) {
                 return translation({v[0], 0});
             },
             1,
             1,
             {asLength<0>}},
    Function{"translateY",
             [](Arguments v) {
                 return translation({0, v[0]});
             },
             1,
             1,
             {asLength<1>}},
    Function{"scaleX", [](Arguments v) { return scalingMatrix(v[0], 1); }, 1, 1, {asFactor}},
    Function{"scaleY", [](Arguments v) { return scalingMatrix(1, v[0]); }, 1, 1, {asFactor}},
    Function{"rotateZ", rotationMatrix, 1, 1, {asAngle}},
};

// The number with its unit that begins here.
std::string_view takeArgument(Scanner& in)
{
    const auto text = in.rest();
    in.number();
    in.word();
    in.take('%');
    return text.substr(0, text.size() - in.rest().size());
}

const Function* findFunction(std::string_view name, const TransformUnits& units)
{
    const auto found = std::ranges::find_if(functions, [&](const Function& each) {
        return units.isCss ? equalsIgnoringCase(each.name, name) : each.name == name;
    });
    return found == functions.end() ? nullptr : &*found;
}

std::optional<Matrix> parseFunction(Scanner& in, const TransformUnits& units)
{
    const Function* const function = findFunction(in.word(), units);
    in.skipBlanks();
    if (!function || !in.take('('))
        return std::nullopt;
    std::array<double, 6> v{};
    std::size_t count = 0;
    for (in.skipBlanks(); !in.take(')'); in.skipSeparator()) {
        if (count == function->most)
            return std::nullopt;
        const auto argument = function->arguments[count](takeArgument(in), units);
        if (!argument)
            return std::nullopt;
        v[count++] = *argument;
    }
    if (count != function->fewest && count != function->most)
        return std::nullopt;
    if (function->name == "scale" && count == 1)
        v[1] = v[0];
    return function->matrix(v);
}

// Converts "xMidYMin" to the shares of free space before the drawing: 0, 1/2 or 1 on each axis.
Point alignment(std::string_view word)
{
    const auto part = [](std::string_view s) { return s == "Min" ? 0.0 : s == "Max" ? 1.0 : 0.5; };
    return word.size() == 8 ? Point{part(word.substr(1, 3)), part(word.substr(5, 3))}
                            : Point{0.5, 0.5};
}

} // namespace

double Matrix::scale() const { return std::sqrt(std::abs(determinant())); }

bool Matrix::keepsShapes() const
{
    const double slack = 1e-6 * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d));
    const auto same = [&](double x, double y) { return std::abs(x - y) <= slack; };
    return (same(a, d) && same(b, -c)) || (same(a, -d) && same(b, c));
}

Matrix operator*(const Matrix& outer, const Matrix& inner)
{
    const auto& [a, b, c, d, e, f] = inner;
    return {outer.a * a + outer.c * b,           outer.b * a + outer.d * b,
            outer.a * c + outer.c * d,           outer.b * c + outer.d * d,
            outer.a * e + outer.c * f + outer.e, outer.b * e + outer.d * f + outer.f};
}

AffineMap mapOf(const Matrix& m) { return {{m.a, m.b}, {m.c, m.d}, {0, 0}, {m.e, m.f}}; }

Matrix translation(const Point& by) { return {1, 0, 0, 1, by.x, by.y}; }

std::optional<Matrix> inverse(const Matrix& m)
{
    const double size = m.determinant();
    const Matrix turned{m.d / size,
                        -m.b / size,
                        -m.c / size,
                        m.a / size,
                        (m.c * m.f - m.d * m.e) / size,
                        (m.b * m.e - m.a * m.f) / size};
    const auto finite = [](auto... parts) { return (std::isfinite(parts) && ...); };
    return finite(turned.a, turned.b, turned.c, turned.d, turned.e, turned.f)
               ? std::optional(turned)
               : std::nullopt;
}

std::optional<double> transformLength(std::string_view text, const TransformUnits& units, int axis)
{
    const auto length = units.lengths.parse(text, units.box[axis]);
    return length && (!units.isCss || !lacksUnit(text)) ? length : std::nullopt;
}

std::optional<Matrix> parseTransform(std::string_view text, const TransformUnits& units)
{
    Matrix result;
    if (equalsIgnoringCase(trimmed(text), "none"))
        return result;
    Scanner in(text);
    for (in.skipBlanks(); !in.atEnd(); in.skipSeparator()) {
        const auto next = parseFunction(in, units);
        if (!next)
            return std::nullopt;
        result = result * *next;
    }
    return result;
}

void transform(Subpath& path, const Matrix& matrix)
{
    forEachPoint(path, [&](Point& point) { point = matrix(point); });
}

std::optional<Box> parseViewBox(std::string_view text)
{
    std::array<double, 4> v{};
    Scanner in(trimmed(text));
    for (double& number : v) {
        const auto read = in.number();
        if (!read)
            return std::nullopt;
        number = *read;
        in.skipSeparator();
    }
    if (!(v[2] > 0 && v[3] > 0))
        return std::nullopt;
    return Box{{v[0], v[1]}, {v[2], v[3]}};
}

AspectRatio parseAspectRatio(std::string_view text)
{
    using Fit = AspectRatio::Fit;
    Scanner words(trimmed(text));
    auto align = words.word();
    if (align == "defer") {
        words.skipBlanks();
        align = words.word();
    }
    words.skipBlanks();
    const bool slice = words.word() == "slice";
    return {align == "none" ? Fit::Stretch : slice ? Fit::Slice : Fit::Meet, alignment(align)};
}

Matrix viewBoxTransform(const Box& viewBox, const Box& viewport,
                        std::string_view preserveAspectRatio)
{
    const auto [fit, alignment] = parseAspectRatio(preserveAspectRatio);
    Point scale = viewport.size / viewBox.size;
    if (fit != AspectRatio::Fit::Stretch)
        scale = Point(fit == AspectRatio::Fit::Slice ? std::max(scale.x, scale.y)
                                                     : std::min(scale.x, scale.y));
    const Point free = viewport.size - viewBox.size * scale;
    return translation(viewport.min + free * alignment) * Matrix{scale.x, 0, 0, scale.y, 0, 0}
           * translation(-viewBox.min);
}

} // namespace app::svg
