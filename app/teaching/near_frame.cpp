// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/near_frame.h"

#include "app/base/finite.h"
#include "app/comparison/variants.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double mostOfWidth = 0.58, mostOfHeight = 0.60;
/// A line whose box takes less than this of both sides is magnified.
constexpr double small = 0.2;

/// Whether a line is small in a picture, in sight or not.
bool isTinyIn(const FigureFrame& frame, const clipping::Segment& line)
{
    const Point way = glm::abs(line.b / 2.0 - line.a / 2.0);
    const Point shown = frame.seen.max / 2.0 - frame.seen.min / 2.0;
    return way.x < small * shown.x && way.y < small * shown.y;
}

/// The line, and what a wrong result shows beyond its box: as a diagonal of both together.
clipping::Segment withResult(const TracedLine& tracedLine)
{
    const clipping::Segment& line = tracedLine.line;
    if (!tracedLine.variant.algorithm || !tracedLine.corners.empty()
        || !refusalOf(tracedLine).isEmpty())
        return line;
    const auto piece = clipped(tracedLine.variant, line, tracedLine.window);
    if (!piece || !isFinite(piece->a) || !isFinite(piece->b))
        return line;
    const Point low = glm::min(line.a, line.b), high = glm::max(line.a, line.b);
    const Point from = glm::min(low, glm::min(piece->a, piece->b));
    const Point to = glm::max(high, glm::max(piece->a, piece->b));
    constexpr double seen = 0.01; // of the line's box: less is rounding
    const double most = seen * std::max(high.x - low.x, high.y - low.y);
    const Point more = glm::max(low - from, to - high);
    return std::max(more.x, more.y) > most ? clipping::Segment{from, to} : line;
}

} // namespace

std::optional<clipping::Window> magnifying(const clipping::Segment& line, const QSizeF& picture)
{
    if (!isFinite(line.a) || !isFinite(line.b) || picture.isEmpty())
        return std::nullopt;
    // Halves, so that the largest numbers do not overflow.
    const Point middle = line.a / 2.0 + line.b / 2.0, way = line.b / 2.0 - line.a / 2.0;
    const Point size(picture.width(), picture.height());
    const double perPixel = std::max(std::abs(way.x) / (mostOfWidth * size.x),
                                     std::abs(way.y) / (mostOfHeight * size.y));
    const Point half = perPixel * size;
    const double least = std::max(1e-12 * std::max(std::abs(middle.x), std::abs(middle.y)), 1e-290);
    if (!(std::min(half.x, half.y) > least))
        return std::nullopt;
    const clipping::Window seen{middle - half, middle + half};
    return isFinite(seen.min) && isFinite(seen.max) ? std::optional(seen) : std::nullopt;
}

FigureFrame nearFrame(const TracedLine& tracedLine, const QSizeF& size, const QFont& font)
{
    FigureFrame frame = figureFrame(tracedLine, size, font);
    frame.hasScale = true;
    if (const clipping::Segment shown = withResult(tracedLine); isTinyIn(frame, shown))
        frame.seen = magnifying(shown, size).value_or(frame.seen);
    return frame;
}

} // namespace app
