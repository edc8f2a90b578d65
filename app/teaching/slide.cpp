// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/slide.h"

#include "app/teaching/figure.h"
#include "app/teaching/figure_marks.h"
#include "app/teaching/slide_panels.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QTextOption>

#include <algorithm>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Slide", text); }

constexpr double margin = 32, columnWidth = 560, gap = 24;
constexpr double top = 90, bottom = slideHeight - margin; // of the area below the header
constexpr double sentenceHeight = 132, operationsHeight = 88;

QString stepText(const Walk& walk, std::size_t step)
{
    return walk.moments.empty() ? QString()
                                : tr("Step %1 of %2").arg(step + 1).arg(walk.moments.size());
}

/// "Line from −160, −30 to 70, 130, window from −100, −75 to 100, 75".
QString factsText(const Specimen& specimen)
{
    return tr("Line from %1 to %2, window from %3 to %4")
        .arg(pointText(specimen.line.a), pointText(specimen.line.b), pointText(specimen.window.min),
             pointText(specimen.window.max));
}

void paintHeader(QPainter& painter, const Specimen& specimen, const Walk& walk, std::size_t step,
                 Ground ground)
{
    const FigureColours colours = figureColours(ground);
    const QFont body = slideFonts().body;
    const QRectF line(margin, 16, slideWidth - 2 * margin, 34);
    paintMarker(painter, QRectF(line.left(), line.top() + 7, 20, 20), specimen.variant, ground);
    painter.setFont(bold(sized(body, 1.4)));
    painter.setPen(colours.text);
    painter.drawText(line.adjusted(30, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     titleOf(specimen.variant));
    painter.setFont(sized(body, 1.1));
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, stepText(walk, step));
    painter.setFont(sized(body, 0.9));
    painter.setPen(colours.muted);
    painter.drawText(line.translated(30, 32), Qt::AlignLeft | Qt::AlignVCenter,
                     factsText(specimen));
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

void paintFigure(QPainter& painter, const QRectF& area, const WalkStep& at, Ground ground)
{
    const FigureFrame frame = nearFrame(at.specimen, area.size(), slideFonts().body);
    painter.save();
    painter.translate(area.topLeft());
    paintStep(painter, at, frame, figureColours(ground));
    painter.restore();
}

void paintPanels(QPainter& painter, const QRectF& column, const Walk& walk, std::size_t step,
                 const FigureColours& colours)
{
    QRectF code = column;
    code.setHeight(column.height() * 0.48);
    const double below =
        walk.code.isEmpty() ? column.top() : paintCode(painter, code, walk, step, colours) + 14;
    if (walk.moments.empty())
        return;
    const QRectF variables(column.left(), below, column.width(),
                           column.bottom() - operationsHeight - 10 - below);
    paintVariables(painter, variables, walk.moments[step], colours);
    const QRectF operations(column.left(), column.bottom() - operationsHeight, column.width(),
                            operationsHeight);
    paintOperations(painter, operations, walk, step, colours);
}

} // namespace

void paintSlide(QPainter& painter, const WalkStep& at, SlideParts parts, Ground ground)
{
    const auto& [specimen, walk, step] = at;
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
    paintHeader(painter, specimen, walk, step, ground);
    paintFigure(painter, picture, at, ground);
    painter.setPen(QPen(colours.rule, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(picture);
    paintSentence(painter, sentence, slideSentence(walk, step), colours);
    paintPanels(painter, column, walk, step, colours);
}

QRectF sentenceArea()
{
    return {margin, bottom - sentenceHeight, slideWidth - 2 * margin - columnWidth - gap,
            sentenceHeight};
}

QString slideTitle(const Specimen& specimen, const Walk& walk, std::size_t step)
{
    return walk.moments.empty() ? titleOf(specimen.variant)
                                : tr("%1, step %2 of %3")
                                      .arg(titleOf(specimen.variant))
                                      .arg(step + 1)
                                      .arg(walk.moments.size());
}

QString slideSentence(const Walk& walk, std::size_t step)
{
    return step < walk.moments.size() ? walk.moments[step].sentence : walk.refusal;
}

} // namespace app
