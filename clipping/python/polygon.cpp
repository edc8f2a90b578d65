// SPDX-License-Identifier: MIT
#include "clipping/clip.h"
#include "clipping/polygon/window_data.h"
#include "clipping/python/module.h"

namespace clipping::python {
namespace {

/// The rows other than `exact` number the edges of the polygon that is given to them. This is the
/// number of the same edge between the corners as the user gave them.
std::uint32_t givenNumber(std::uint32_t number, const PreparedPolygon& polygon)
{
    return number == 0 || number > polygon.numbers.size() ? number : polygon.numbers[number - 1];
}

} // namespace

ConvexWindow polygonOf(std::span<const glm::dvec2> corners)
{
    const ConvexWindow window = ConvexPolygon::from(corners);
    if (!window)
        throw pybind11::value_error(window.whyNot());
    return window;
}

std::size_t clipAllAt(const ConvexWindow& window, const Algorithm& row, std::span<const Segment> in,
                      std::span<Clipped> out)
{
    if (&row == &exactAlgorithm())
        return clipAll(in, window, Output<double>(out)).visible;
    const PreparedPolygon& polygon = window.data()->polygon;
    const std::size_t visible = row.polygon->clipAll(in, {polygon.corners}, out);
    for (Clipped& piece : out.first(visible))
        piece.cut = polygonCutAt(givenNumber(polygonEdgeOfA(piece.cut), polygon),
                                 givenNumber(polygonEdgeOfB(piece.cut), polygon));
    return visible;
}

} // namespace clipping::python
