// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/page_figure.h"

#include "app/teaching/figure.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <array>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Page", text); }

constexpr clipping::Segment twoEdges{{-160, -30}, {70, 130}};

// THE CATALOGUE. What is typical of an algorithm, shown at the step where it is seen best.
constexpr std::array figures{
    PageFigure{"cohen-sutherland", {{-170, -120}, {130, 60}}, Mark::Cut}, // an end is cut twice
    PageFigure{"cyrus-beck", twoEdges, Mark::Cut},
    PageFigure{"liang-barsky", twoEdges, Mark::Divide}, // a parameter, and where it is on the line
    PageFigure{"sobkow-pospisil-yang", {{-150, 40}, {20, -120}}, Mark::Cut},
    PageFigure{"nicholl-lee-nicholl", {{-160, -100}, {150, 20}}, Mark::Cut},
    PageFigure{
        "midpoint-subdivision", {{-40, -10}, {160, 110}}, Mark::Cut}, // halves without division
    PageFigure{"slater-barsky", {{-150, 20}, {140, -40}}, Mark::Cut},
    PageFigure{"skala", {{-170, -20}, {60, 140}}, Mark::Cut}, // two intersections at once
    PageFigure{"kodituwakku-wijeweera-chamikara", {{-150, -110}, {120, 100}}, Mark::Cut},
    PageFigure{"matthes-drakopoulos", twoEdges, Mark::Cut},
    PageFigure{"exact", {{-160, 10}, {-20, 120}}, Mark::Cut}, // close by a corner
};

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

PageFigure pageFigureOf(const clipping::Algorithm& algorithm)
{
    const auto found = std::ranges::find(figures, algorithm.key, &PageFigure::key);
    return found != figures.end() ? *found : PageFigure{algorithm.key, twoEdges, Mark::Cut};
}

Specimen specimenOf(const PageFigure& figure)
{
    return {.clipper = {clipping::findAlgorithm(figure.key), figure.form},
            .line = figure.line,
            .window = figure.window,
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
    const PageFigure figure = pageFigureOf(algorithm);
    const Walk walk = walkOf(specimenOf(figure));
    const std::size_t step = stepOf(figure, walk);
    return tr("Step %1 of %2: %3")
        .arg(step + 1)
        .arg(walk.moments.size())
        .arg(walk.moments[step].sentence);
}

QImage pageFigure(const clipping::Algorithm& algorithm, Ground ground, int width,
                  double devicePixels)
{
    const PageFigure figure = pageFigureOf(algorithm);
    const Specimen specimen = specimenOf(figure);
    const Walk walk = walkOf(specimen);
    return painted({specimen, walk, stepOf(figure, walk)}, ground, {width, width * 9 / 16},
                   devicePixels);
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
