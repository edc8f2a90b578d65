// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure.h"

#include "app/teaching/figure_labels.h"
#include "app/teaching/paint_window.h"
#include "app/teaching/scale_bar.h"

#include <QFontMetricsF>
#include <QPainter>

#include <array>

namespace app {

namespace {

QPen pen(const QColor& colour, double width, Qt::PenCapStyle cap = Qt::FlatCap)
{
    return {colour, width, Qt::SolidLine, cap, Qt::MiterJoin};
}

QPen dashed(const QColor& colour, double width)
{
    QPen dashes = pen(colour, width);
    dashes.setDashPattern({3.2, 2.4});
    return dashes;
}

void strike(const FigurePainting& s, const clipping::Segment& line, const QPen& with)
{
    if (const auto part = s.frame.part(line)) {
        s.painter.setPen(with);
        s.painter.drawLine(*part);
    }
}

/// Two short strokes across the middle of a rejected line.
void crossOut(const FigurePainting& s)
{
    const auto part = s.frame.part(s.tracedLine.line);
    if (!part)
        return;
    const QPointF middle = part->center();
    const double r = 7 * s.frame.unit();
    s.painter.setPen(pen(s.colours.muted, 2.5 * s.frame.unit(), Qt::RoundCap));
    s.painter.drawLine(middle - QPointF(r, r), middle + QPointF(r, r));
    s.painter.drawLine(middle - QPointF(r, -r), middle + QPointF(r, -r));
}

void paintLine(const FigurePainting& s)
{
    const QPen gone = dashed(s.colours.muted, 1.75 * s.frame.unit());
    if (s.scene.state == StepScene::State::Rejected) {
        strike(s, s.tracedLine.line, gone);
        crossOut(s);
        return;
    }
    for (const auto& piece : s.scene.discarded)
        strike(s, piece, gone);
    for (const auto& piece : s.scene.discardedNow)
        strike(s, piece, dashed(s.colours.highlight, 2 * s.frame.unit()));
    const bool accepted = s.scene.state == StepScene::State::Accepted;
    const auto& left = s.scene.left;
    strike(s, left, pen(s.colours.text, (accepted ? 4.5 : 3.5) * s.frame.unit()));
    if (left.a == left.b && s.frame.shows(left.a)) {
        s.painter.setPen(Qt::NoPen);
        s.painter.setBrush(s.colours.text);
        s.painter.drawEllipse(s.frame.at(left.a), 3 * s.frame.unit(), 3 * s.frame.unit());
    }
}

QColor colourOf(FigureMark::Tone tone, const FigureColours& colours)
{
    return tone == FigureMark::Tone::Highlighted ? colours.highlight
           : tone == FigureMark::Tone::Muted     ? colours.muted
                                                 : colours.text;
}

QPolygonF diamond(const QPointF& at, double r)
{
    return QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r),
                     at + QPointF(-r, 0)};
}

/// An arrow head at the picture's border that points to the end.
QPolygonF arrowHead(const FigureMark& mark, double r)
{
    const QLineF way = QLineF::fromPolar(r, mark.angle);
    const QPointF ahead(way.dx(), way.dy()), aside(-way.dy(), way.dx());
    return QPolygonF{mark.place + ahead, mark.place - ahead * 0.6 + aside * 0.75,
                     mark.place - ahead * 0.6 - aside * 0.75};
}

void paintMark(const FigurePainting& s, const FigureMark& mark)
{
    using Shape = FigureMark::Shape;
    const QColor colour = colourOf(mark.tone, s.colours);
    const double r = radiusOf(mark, s.frame);
    const bool hollow = mark.shape == Shape::End || mark.shape == Shape::Candidate;
    s.painter.setPen(hollow ? pen(colour, 2 * s.frame.unit())
                            : pen(s.colours.paper, 1.5 * s.frame.unit()));
    s.painter.setBrush(hollow ? s.colours.paper : colour);
    if (mark.shape == Shape::End)
        s.painter.drawEllipse(mark.place, r, r);
    else
        s.painter.drawPolygon(mark.shape == Shape::FarEnd ? arrowHead(mark, r)
                                                          : diamond(mark.place, r));
}

QColor headColour(FigureLabel::Tone tone, const FigureColours& colours)
{
    const std::array row{colours.text,  colours.onHighlight, colours.window,
                         colours.muted, colours.window,      colours.highlight};
    return row[std::size_t(tone)];
}

void paintLeader(const FigurePainting& s, const FigureLabel& label)
{
    if (!label.leader)
        return;
    const QPointF& mark = *label.leader;
    const QPointF from(std::clamp(mark.x(), label.box.left(), label.box.right()),
                       std::clamp(mark.y(), label.box.top(), label.box.bottom()));
    s.painter.setPen(pen(s.colours.muted, 0.75 * s.frame.unit()));
    s.painter.drawLine(from, mark);
}

/// Paints a label's texts into an area at the origin.
void paintTexts(const FigurePainting& s, const FigureLabel& label, const QRectF& text)
{
    const QFont head = headFont(s.frame, label.tone), detail = detailFont(s.frame);
    const QFontMetricsF heads(head), details(detail);
    s.painter.setFont(head);
    s.painter.setPen(headColour(label.tone, s.colours));
    s.painter.drawText(text.topLeft() + QPointF(0, heads.ascent()), label.head);
    if (label.detail.isEmpty())
        return;
    s.painter.setFont(detail);
    s.painter.setPen(label.tone == FigureLabel::Tone::Highlighted ? s.colours.onHighlight
                                                                  : s.colours.muted);
    const QPointF below(0, heads.height() + details.ascent()),
        beside(heads.horizontalAdvance(label.head) + gapInRow(s.frame), heads.ascent());
    s.painter.drawText(text.topLeft()
                           + (label.layout == FigureLabel::Layout::Stacked ? below : beside),
                       label.detail);
}

void paintLabel(const FigurePainting& s, const FigureLabel& label)
{
    const bool highlight = label.tone == FigureLabel::Tone::Highlighted;
    if (highlight || label.coversEdge) {
        QColor ground = highlight ? s.colours.highlight : s.colours.paper;
        if (!highlight)
            ground.setAlphaF(0.82F);
        s.painter.setPen(Qt::NoPen);
        s.painter.setBrush(ground);
        s.painter.drawRoundedRect(label.box, 2 * s.frame.unit(), 2 * s.frame.unit());
    }
    QRectF area = label.box;
    s.painter.save();
    if (label.layout == FigureLabel::Layout::Column) {
        s.painter.translate(label.box.bottomLeft());
        s.painter.rotate(-90);
        area = QRectF(QPointF(), label.box.size().transposed());
    }
    paintTexts(s, label, area.marginsRemoved(paddingOf(s.frame, label.tone)));
    s.painter.restore();
}

} // namespace

void paintStep(QPainter& painter, const TraceStep& at, const FigureFrame& frame,
               const FigureColours& colours)
{
    const auto& [tracedLine, narration, step] = at;
    const StepScene scene = stepScene(tracedLine, narration, step);
    const FigurePainting picture{painter, tracedLine, scene, frame, colours};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(frame.picture(), colours.paper);
    paintGround(picture);
    paintWindow(picture);
    paintLine(picture);
    const auto labels = figureLabels(tracedLine, narration, scene, frame);
    for (const FigureLabel& label : labels)
        paintLeader(picture, label);
    for (const FigureMark& mark : figureMarks(tracedLine, scene, frame))
        paintMark(picture, mark);
    for (const FigureLabel& label : labels)
        paintLabel(picture, label);
    if (const auto bar = scaleBarOf(tracedLine, frame))
        paintScaleBar(painter, *bar, frame, colours);
    painter.restore();
}

} // namespace app
