// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/paint.h"

#include "app/formats/svg/colour.h"
#include "app/formats/svg/colour_sum.h"
#include "app/formats/svg/element_bounds.h"
#include "app/formats/svg/gradient_reader.h"
#include "app/formats/svg/spread_points.h"

#include <algorithm>

namespace app::svg {
namespace {

Colour meanOfStops(const GradientStops& stops)
{
    constexpr int count = 64;
    ColourSum sum;
    for (int i = 0; i < count; ++i)
        sum.add(colourAt(stops, (i + 0.5) / count), 1);
    return sum.mean();
}

bool isPlain(const GradientStops& stops)
{
    return std::ranges::all_of(
        stops, [&](const GradientStop& stop) { return stop.colour == stops.front().colour; });
}

// The box of paths in the element's coordinates.
Box boxOf(std::span<const Subpath> paths, const Matrix& toElement)
{
    ElementBounds bounds;
    for (const Subpath& path : paths) {
        Subpath own = path;
        transform(own, toElement);
        include(bounds, own);
    }
    return {bounds.min, bounds.max - bounds.min};
}

Matrix fromUnitSquare(const Box& box)
{
    return {box.size.x, 0, 0, box.size.y, box.min.x, box.min.y};
}

} // namespace

Style Paints::style(const Properties& p, double opacity, const StrokeScale& scale,
                    const PaintedShape& shape)
{
    Style style{.stroke = colour(p.stroke, opacity * p.strokeOpacity, p, shape, Part::Stroke),
                .fill = colour(p.fill, opacity * p.fillOpacity, p, shape, Part::Fill),
                .width = p.width * scale.across,
                .miterLimit = p.miterLimit,
                .dashOffset = p.dashOffset * scale.along,
                .dashes = p.dashes,
                .cap = p.cap,
                .join = p.join,
                .fillRule = p.fillRule};
    for (double& dash : style.dashes)
        dash *= scale.along;
    return style;
}

std::optional<Colour> Paints::colour(const Paint& paint, double opacity, const Properties& p,
                                     const PaintedShape& shape, Part part)
{
    std::optional<Colour> colour;
    if (paint.kind == Paint::Kind::Solid)
        colour = paint.colour;
    else if (paint.kind == Paint::Kind::Current)
        colour = p.colour;
    else if (paint.kind == Paint::Kind::Reference)
        colour = referenced(paint, p, shape, part);
    else if (paint.kind == Paint::Kind::ContextFill)
        return this->colour(p.contextFill, opacity, p, shape, part);
    else if (paint.kind == Paint::Kind::ContextStroke)
        return this->colour(p.contextStroke, opacity, p, shape, part);
    return colour ? std::optional(faded(*colour, opacity)) : std::nullopt;
}

std::optional<Colour> Paints::referenced(const Paint& paint, const Properties& p,
                                         const PaintedShape& shape, Part part)
{
    const Node node = tree_.findReference(paint.reference);
    if (node != noNode && isGradient(tree_, node))
        return gradientColour(node, p, shape, part);
    if (node != noNode && tree_.name(node) == "pattern") {
        report_.add(losses::pattern);
        const auto toElement = inverse(shape.matrix);
        const auto mean = toElement
                              ? patternColour_(node, boxOf(shape.paths, *toElement), shape.lengths)
                              : std::nullopt;
        if (mean)
            return mean;
    } else if (node != noNode) {
        report_.add(losses::paintServer, tree_.name(node));
    } else if (isElsewhere(paint.reference)) {
        report_.add(losses::otherFile);
    }
    return paint.fallback == Paint::Kind::Solid     ? std::optional(paint.colour)
           : paint.fallback == Paint::Kind::Current ? std::optional(p.colour)
                                                    : std::nullopt;
}

std::optional<Colour> Paints::gradientColour(Node node, const Properties& p,
                                             const PaintedShape& shape, Part part)
{
    const auto [at, isNew] = stops_.try_emplace(node);
    const GradientStops& stops = at->second;
    if (isNew)
        at->second = gradientStops(tree_, node, styles_, report_);
    report_.add(losses::emptyGradient, stops.empty());
    if (stops.empty())
        return std::nullopt;
    if (isPlain(stops))
        return colourOf(stops.front().colour);
    report_.add(losses::gradient);
    const GradientShape lies = gradientShape(tree_, node, shape.lengths);
    const auto toElement = inverse(shape.matrix);
    const Matrix box =
        lies.inBox && toElement ? fromUnitSquare(boxOf(shape.paths, *toElement)) : Matrix{};
    const auto toGradient = inverse(shape.matrix * box * lies.transform);
    if (!toGradient)
        return meanOfStops(stops);
    const auto points = part == Part::Fill ? pointsInside(shape.paths, p.fillRule, rows())
                                           : pointsAlong(shape.paths, rows());
    ColourSum sum;
    for (const SpreadPoint& point : points)
        sum.add(colourAt(stops, placeAlong(lies, (*toGradient)(point.at)).value_or(1)),
                point.weight);
    return points.empty() ? meanOfStops(stops) : sum.mean();
}

// A drawing of a hundred thousand of them should not take a minute.
int Paints::rows()
{
    constexpr int fine = 48, coarse = 12, least = 4;
    constexpr std::size_t few = 2'000, many = 20'000;
    ++shapes_;
    return shapes_ <= few ? fine : shapes_ <= many ? coarse : least;
}

} // namespace app::svg
