// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/quiet_corner.h"

#include "app/teaching/edge_labels.h"
#include "app/teaching/figure_edges.h"

#include <algorithm>
#include <vector>

namespace app {

namespace {

/// The lines and marks that a place can hide, in the picture.
struct Marks {
    std::vector<QPointF> points; ///< ends and cuts
    std::vector<QLineF> line, edges;
    std::vector<QRectF> breaks;
};

Marks marksOf(const TracedLine& tracedLine, const Narration& narration, const FigureFrame& frame)
{
    Marks marks;
    const StepScene last =
        stepScene(tracedLine, narration, std::max<std::size_t>(narration.steps.size(), 1) - 1);
    for (const FigureMark& mark : figureMarks(tracedLine, last, frame))
        marks.points.push_back(mark.place);
    if (const auto part = frame.part(tracedLine.line))
        marks.line.push_back(*part);
    marks.edges = drawnEdges(tracedLine, frame);
    if (tracedLine.corners.empty())
        for (const FigureEdges edges(tracedLine, frame); const auto& mark : edges.breaks())
            marks.breaks.push_back(edges.boxOf(mark));
    return marks;
}

int hiddenBy(const QRectF& box, const Marks& marks)
{
    constexpr double aside = 20; // a part of a mark's label
    const QRectF place = box.adjusted(-aside, -aside, aside, aside);
    const auto crossed = [](const QRectF& area, std::span<const QLineF> lines) {
        return std::ranges::count_if(lines, [&](const QLineF& line) {
            return covers(area, {&line, 1});
        });
    };
    const auto points = std::ranges::count_if(
        marks.points, [&](const QPointF& point) { return place.contains(point); });
    const auto breaks = std::ranges::count_if(
        marks.breaks, [&](const QRectF& mark) { return box.intersects(mark); });
    return int(8 * points + 4 * crossed(place, marks.line) + crossed(box, marks.edges) + breaks);
}

struct Insets {
    double left, top, right, bottom;
};

/// The distances from the border; the scale bar is below.
Insets besideBorder(const FigureFrame& frame)
{
    constexpr double margin = 12; // pixels
    return {margin, margin, margin, margin + (frame.hasScale ? 22 * frame.unit() : 0)};
}

/// The same, but inside the edges at the rim.
Insets insideOfRim(const TracedLine& tracedLine, const FigureFrame& frame)
{
    Insets insets = besideBorder(frame);
    if (!tracedLine.corners.empty())
        return insets;
    const FigureEdges edges(tracedLine, frame);
    const double clear = 18 * frame.unit(); // of the rim and its break marks
    const auto use = [&](clipping::Edge edge, double& before, double& after, double length) {
        const EdgePlace& place = edges[edge];
        if (place.at != EdgePlace::At::Rim)
            return;
        if (place.inward > 0)
            before = std::max(before, place.place + clear);
        else
            after = std::max(after, length - place.place + clear);
    };
    for (const clipping::Edge edge : {clipping::Edge::Left, clipping::Edge::Right})
        use(edge, insets.left, insets.right, frame.size.width());
    for (const clipping::Edge edge : {clipping::Edge::Bottom, clipping::Edge::Top})
        use(edge, insets.top, insets.bottom, frame.size.height());
    return insets;
}

QRectF boxIn(Qt::Corner corner, const QSizeF& size, const Insets& insets, const QSizeF& picture)
{
    QRectF box({insets.left, insets.top}, size);
    if (corner == Qt::TopRightCorner || corner == Qt::BottomRightCorner)
        box.moveRight(picture.width() - insets.right);
    if (corner == Qt::BottomLeftCorner || corner == Qt::BottomRightCorner)
        box.moveBottom(picture.height() - insets.bottom);
    return box;
}

CornerPlace placeAmong(const Marks& marks, Qt::Corner corner, const QSizeF& box,
                       const TracedLine& tracedLine, const FigureFrame& frame)
{
    CornerPlace best{corner, {}, 0};
    for (const Insets& insets : {insideOfRim(tracedLine, frame), besideBorder(frame)}) {
        const QRectF place = boxIn(corner, box, insets, frame.size);
        const int hidden = hiddenBy(place, marks);
        if (best.box.isNull() || hidden < best.covered)
            best = {corner, place, hidden};
    }
    return best;
}

} // namespace

CornerPlace placeIn(Qt::Corner corner, const QSizeF& box, const TracedLine& tracedLine,
                    const Narration& narration, const FigureFrame& frame)
{
    return placeAmong(marksOf(tracedLine, narration, frame), corner, box, tracedLine, frame);
}

CornerPlace quietCorner(const QSizeF& box, const TracedLine& tracedLine, const Narration& narration,
                        const FigureFrame& frame)
{
    const Marks marks = marksOf(tracedLine, narration, frame);
    std::vector<CornerPlace> places;
    for (const Qt::Corner corner :
         {Qt::TopLeftCorner, Qt::TopRightCorner, Qt::BottomRightCorner, Qt::BottomLeftCorner})
        places.push_back(placeAmong(marks, corner, box, tracedLine, frame));
    return *std::ranges::min_element(places, {}, &CornerPlace::covered);
}

} // namespace app
