// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/page_figure.h"

#include "app/teaching/figure.h"

#include <QGuiApplication>
#include <QPainter>

#include <algorithm>

namespace app {

namespace {

constexpr clipping::Window window{{-100, -75}, {100, 75}}; // the paper's

QImage painted(const TraceStep& at, Ground ground, const QSize& size, double devicePixels)
{
    QImage image(size * devicePixels, QImage::Format_RGB32);
    if (image.isNull())
        return image;
    image.setDevicePixelRatio(devicePixels);
    QFont font = QGuiApplication::font();
    font.setPixelSize(std::max(9, size.width() / 52));
    QPainter painter(&image);
    paintStep(painter, at, figureFrame(at.tracedLine, size, font), figureColours(ground));
    return image;
}

} // namespace

TracedLine pageTracedLine(const clipping::Algorithm& algorithm)
{
    return {.variant = {&algorithm, clipping::Form::Corrected},
            .line = teachingOf(algorithm).figure.line,
            .window = window,
            .y = YAxis::Up,
            .origin = {}};
}

std::size_t stepOf(const PageFigure& figure, const Narration& narration)
{
    for (std::size_t i = narration.steps.size(); i > 0; --i)
        if (narration.steps[i - 1].mark == figure.mark)
            return i - 1;
    return std::max<std::size_t>(narration.steps.size(), 1) - 1;
}

QImage pageFigure(const clipping::Algorithm& algorithm, Ground ground, int width,
                  double devicePixels)
{
    const TracedLine tracedLine = pageTracedLine(algorithm);
    const Narration narration = narrationOf(tracedLine);
    if (narration.steps.empty())
        return {};
    return painted({tracedLine, narration, stepOf(teachingOf(algorithm).figure, narration)}, ground,
                   {width, width * 9 / 16}, devicePixels);
}

QImage pageFigure(const QString& address, Ground ground, int width, double devicePixels)
{
    const QString scheme = QStringLiteral("figure:");
    const auto* algorithm =
        address.startsWith(scheme)
            ? clipping::findAlgorithm(address.sliced(scheme.size()).toStdString())
            : nullptr;
    return algorithm ? pageFigure(*algorithm, ground, width, devicePixels) : QImage();
}

} // namespace app
