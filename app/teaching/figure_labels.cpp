// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_labels.h"

#include "app/teaching/edge_labels.h"
#include "app/teaching/figure_edges.h"
#include "app/teaching/scale_bar.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using LabelTone = FigureLabel::Tone;

QRectF boxOf(const FigureMark& mark, const FigureFrame& frame)
{
    const double r = radiusOf(mark, frame) + frame.unit();
    return {mark.place.x() - r, mark.place.y() - r, 2 * r, 2 * r};
}

/// The obstacles before any label is placed: marks, including those of later steps, so that labels
/// keep their places; the line; the infinite lines of the edges.
LabelObstacles obstaclesOf(const TracedLine& tracedLine, const Narration& narration,
                           const StepScene& scene, const FigureFrame& frame)
{
    const double m = 6 * frame.unit();
    LabelObstacles obstacles{frame.picture().adjusted(m, m, -m, -m), {}, {}, {}};
    if (!frame.reserved.isEmpty())
        obstacles.boxes.push_back(frame.reserved);
    obstacles.boxes.insert(obstacles.boxes.end(), frame.discs.begin(), frame.discs.end());
    for (const FigureMark& mark : figureMarks(tracedLine, scene, frame))
        obstacles.boxes.push_back(boxOf(mark, frame));
    if (!narration.steps.empty())
        for (const FigureMark& mark : figureMarks(
                 tracedLine, stepScene(tracedLine, narration, narration.steps.size() - 1), frame))
            obstacles.boxes.push_back(boxOf(mark, frame));
    std::vector<clipping::Segment> lines{tracedLine.line, scene.left};
    lines.insert(lines.end(), scene.discarded.begin(), scene.discarded.end());
    lines.insert(lines.end(), scene.discardedNow.begin(), scene.discardedNow.end());
    for (const auto& line : lines)
        if (const auto part = frame.part(line))
            obstacles.lines.push_back(*part);
    if (const auto bar = scaleBarOf(tracedLine, frame))
        obstacles.boxes.push_back(bar->box);
    obstacles.avoided = drawnEdges(tracedLine, frame);
    if (tracedLine.corners.empty())
        for (const FigureEdges edges(tracedLine, frame); const auto& mark : edges.breaks())
            obstacles.boxes.push_back(edges.boxOf(mark));
    return obstacles;
}

void labelMark(std::vector<FigureLabel>& labels, const FigureMark& mark, LabelObstacles& obstacles,
               const FigureFrame& frame)
{
    const bool boxed =
        mark.shape == FigureMark::Shape::Cut && mark.tone == FigureMark::Tone::Highlighted;
    const FigureLabel label{.tone = boxed ? LabelTone::Highlighted : LabelTone::Plain,
                            .head = mark.head,
                            .detail = mark.detail};
    const QSizeF size = sizeOf(label, frame);
    const double radius = radiusOf(mark, frame);
    if (!placeLabel(labels, label, placesAround(mark.place, radius, size), obstacles)
        && !placeLabel(labels, label, placesWithin(obstacles.inside, mark.place, size), obstacles))
        return;
    FigureLabel& placed = labels.back();
    const QPointF nearest(std::clamp(mark.place.x(), placed.box.left(), placed.box.right()),
                          std::clamp(mark.place.y(), placed.box.top(), placed.box.bottom()));
    if (QLineF(nearest, mark.place).length() > 3.2 * radius)
        placed.leader = mark.place;
}

/// Whether a label's texts stand beside each other.
bool isRow(const FigureLabel& label) { return label.layout != FigureLabel::Layout::Stacked; }

} // namespace

QFont headFont(const FigureFrame& frame, LabelTone tone)
{
    QFont font = frame.font;
    if (tone == LabelTone::Edge || tone == LabelTone::RimEdge)
        return detailFont(frame);
    font.setWeight(QFont::DemiBold);
    if (tone != LabelTone::Plain && tone != LabelTone::Highlighted)
        font.setPixelSize(detailFont(frame).pixelSize());
    return font;
}

QFont detailFont(const FigureFrame& frame)
{
    QFont font = frame.font;
    font.setPixelSize(std::max(1, qRound(font.pixelSize() * 0.92)));
    return font;
}

QMarginsF paddingOf(const FigureFrame& frame, LabelTone tone)
{
    const double u = frame.unit();
    return tone == LabelTone::Highlighted ? QMarginsF(9, 5, 9, 5) * u : QMarginsF(3, 1, 3, 1) * u;
}

double gapInRow(const FigureFrame& frame) { return 7 * frame.unit(); }

QSizeF sizeOf(const FigureLabel& label, const FigureFrame& frame)
{
    const QFontMetricsF head(headFont(frame, label.tone)), detail(detailFont(frame));
    const double one = head.horizontalAdvance(label.head),
                 other = detail.horizontalAdvance(label.detail);
    const bool both = !label.detail.isEmpty();
    QSizeF text(std::max(one, other), head.height() + (both ? detail.height() : 0));
    if (isRow(label))
        text = {one + (both ? gapInRow(frame) + other : 0),
                std::max(head.height(), detail.height())};
    const QSizeF size = QRectF(0, 0, std::ceil(text.width()), std::ceil(text.height()))
                            .marginsAdded(paddingOf(frame, label.tone))
                            .size();
    return label.layout == FigureLabel::Layout::Column ? size.transposed() : size;
}

bool placeLabel(std::vector<FigureLabel>& labels, FigureLabel label, std::span<const QRectF> places,
                LabelObstacles& obstacles)
{
    const auto box = freePlace(places, obstacles);
    if (!box)
        return false;
    label.box = *box;
    label.coversEdge = covers(*box, obstacles.avoided);
    obstacles.boxes.push_back(*box);
    labels.push_back(std::move(label));
    return true;
}

std::vector<FigureLabel> figureLabels(const TracedLine& tracedLine, const Narration& narration,
                                      const StepScene& scene, const FigureFrame& frame)
{
    LabelObstacles obstacles = obstaclesOf(tracedLine, narration, scene, frame);
    std::vector<FigureLabel> labels;
    for (const FigureMark& mark : figureMarks(tracedLine, scene, frame))
        if (!mark.head.isEmpty())
            labelMark(labels, mark, obstacles, frame);
    labelEdges(labels, tracedLine, scene, obstacles, frame);
    return labels;
}

} // namespace app
