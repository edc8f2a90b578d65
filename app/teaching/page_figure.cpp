// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/page_figure.h"

#include "app/teaching/figure.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Page", text); }

constexpr clipping::Window window{{-100, -75}, {100, 75}}; // the paper's

QImage painted(const WalkStep& at, Ground ground, const QSize& size, double devicePixels)
{
    QImage image(size * devicePixels, QImage::Format_RGB32);
    if (image.isNull())
        return image;
    image.setDevicePixelRatio(devicePixels);
    QFont font = QGuiApplication::font();
    font.setPixelSize(std::max(9, size.width() / 52));
    QPainter painter(&image);
    paintStep(painter, at, figureFrame(at.specimen, size, font), figureColours(ground));
    return image;
}

} // namespace

Specimen pageSpecimen(const clipping::Algorithm& algorithm)
{
    return {.variant = {&algorithm, clipping::Form::Corrected},
            .line = teachingOf(algorithm).figure.line,
            .window = window,
            .y = YAxis::Up,
            .origin = {}};
}

std::size_t stepOf(const PageFigure& figure, const Walk& walk)
{
    for (std::size_t i = walk.moments.size(); i > 0; --i)
        if (walk.moments[i - 1].mark == figure.mark)
            return i - 1;
    return std::max<std::size_t>(walk.moments.size(), 1) - 1;
}

QString pageFigureCaption(const clipping::Algorithm& algorithm)
{
    const Walk walk = walkOf(pageSpecimen(algorithm));
    if (walk.moments.empty())
        return {};
    const std::size_t step = stepOf(teachingOf(algorithm).figure, walk);
    return tr("Step %1 of %2: %3")
        .arg(step + 1)
        .arg(walk.moments.size())
        .arg(walk.moments[step].sentence);
}

QImage pageFigure(const clipping::Algorithm& algorithm, Ground ground, int width,
                  double devicePixels)
{
    const Specimen specimen = pageSpecimen(algorithm);
    const Walk walk = walkOf(specimen);
    if (walk.moments.empty())
        return {};
    return painted({specimen, walk, stepOf(teachingOf(algorithm).figure, walk)}, ground,
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
