// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/slide.h"

#include "app/base/text.h"
#include "app/teaching/figure.h"
#include "app/teaching/figure_marks.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/slide_panels.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QTextOption>

#include <algorithm>

namespace app {

namespace {

constexpr double margin = 32, columnWidth = 560, gap = 24;
constexpr double top = 90, bottom = slideHeight - margin; // of the area below the header
constexpr double sentenceHeight = 132, operationsHeight = 88;

QString slideStepText(const Narration& narration, std::size_t step)
{
    return narration.steps.empty()
               ? QString()
               : Text::tr("Step %1 of %2").arg(step + 1).arg(narration.steps.size());
}

/// "Line from −160, −30 to 70, 130, convex window with 5 corners".
QString polygonFacts(const TracedLine& tracedLine)
{
    return Text::tr("Line from %1 to %2, convex window with %3 corners")
        .arg(pointText(tracedLine.line.a), pointText(tracedLine.line.b))
        .arg(tracedLine.corners.size());
}

/// "Line from −160, −30 to 70, 130, window from −100, −75 to 100, 75".
QString factsText(const TracedLine& tracedLine)
{
    if (!tracedLine.corners.empty())
        return polygonFacts(tracedLine);
    return (tracedLine.windowIsPage ? Text::tr("Line from %1 to %2, page from %3 to %4")
                                    : Text::tr("Line from %1 to %2, window from %3 to %4"))
        .arg(pointText(tracedLine.line.a), pointText(tracedLine.line.b),
             pointText(tracedLine.window.min), pointText(tracedLine.window.max));
}

void paintHeader(QPainter& painter, const TracedLine& tracedLine, const Narration& narration,
                 std::size_t step, Ground ground)
{
    const FigureColours colours = figureColours(ground);
    const QFont body = slideFonts().body;
    const QRectF line(margin, 16, slideWidth - 2 * margin, 34);
    paintMarker(painter, QRectF(line.left(), line.top() + 7, 20, 20), tracedLine.variant, ground);
    painter.setFont(bold(sized(body, 1.4)));
    painter.setPen(colours.text);
    painter.drawText(line.adjusted(30, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     titleOf(tracedLine.variant));
    painter.setFont(sized(body, 1.1));
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, slideStepText(narration, step));
    painter.setFont(sized(body, 0.9));
    painter.setPen(colours.muted);
    painter.drawText(line.translated(30, 32), Qt::AlignLeft | Qt::AlignVCenter,
                     factsText(tracedLine));
}

/// Paints a sentence in the largest font that fits.
void paintSentence(QPainter& painter, const QRectF& area, const QString& text,
                   const FigureColours& colours)
{
    QFont font = slideFonts().body;
    const int flags = Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop;
    for (int size = 22; size >= 18; --size) {
        font.setPixelSize(size);
        if (QFontMetricsF(font).boundingRect(area, flags, text).height() <= area.height())
            break;
    }
    painter.setFont(font);
    painter.setPen(colours.text);
    painter.drawText(area, flags, text);
}

void paintFigure(QPainter& painter, const QRectF& area, const TraceStep& at, Ground ground)
{
    const FigureFrame frame = nearFrame(at.tracedLine, area.size(), slideFonts().body);
    painter.save();
    painter.translate(area.topLeft());
    paintStep(painter, at, frame, figureColours(ground));
    painter.restore();
}

void paintPanels(QPainter& painter, const QRectF& column, const Narration& narration,
                 std::size_t step, const FigureColours& colours)
{
    QRectF code = column;
    code.setHeight(column.height() * 0.48);
    const double below = narration.code.isEmpty()
                             ? column.top()
                             : paintCode(painter, code, narration, step, colours) + 14;
    if (narration.steps.empty())
        return;
    const QRectF variables(column.left(), below, column.width(),
                           column.bottom() - operationsHeight - 10 - below);
    paintVariables(painter, variables, narration.steps[step], colours);
    const QRectF operations(column.left(), column.bottom() - operationsHeight, column.width(),
                            operationsHeight);
    paintOperations(painter, operations, narration, step, colours);
}

} // namespace

void paintSlide(QPainter& painter, const TraceStep& at, SlideParts parts, Ground ground)
{
    const auto& [tracedLine, narration, step] = at;
    const FigureColours colours = figureColours(ground);
    const QRectF all(0, 0, slideWidth, slideHeight);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(all, colours.paper);
    if (parts == SlideParts::Picture) {
        paintFigure(painter, all, at, ground);
        return;
    }
    const QRectF column(slideWidth - margin - columnWidth, top, columnWidth, bottom - top);
    const QRectF sentence = sentenceArea();
    const QRectF picture(margin, top, sentence.width(), sentence.top() - 14 - top);
    paintHeader(painter, tracedLine, narration, step, ground);
    paintFigure(painter, picture, at, ground);
    painter.setPen(QPen(colours.rule, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(picture);
    paintSentence(painter, sentence, slideSentence(narration, step), colours);
    paintPanels(painter, column, narration, step, colours);
}

QRectF sentenceArea()
{
    return {margin, bottom - sentenceHeight, slideWidth - 2 * margin - columnWidth - gap,
            sentenceHeight};
}

QString slideTitle(const TracedLine& tracedLine, const Narration& narration, std::size_t step)
{
    return narration.steps.empty() ? titleOf(tracedLine.variant)
                                   : Text::tr("%1, step %2 of %3")
                                         .arg(titleOf(tracedLine.variant))
                                         .arg(step + 1)
                                         .arg(narration.steps.size());
}

QString slideSentence(const Narration& narration, std::size_t step)
{
    return step < narration.steps.size() ? narration.steps[step].sentence : narration.refusal;
}

} // namespace app
