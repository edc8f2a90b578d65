// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_svg.h"

#include "app/teaching/figure.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/svg_device.h"

#include <QGuiApplication>
#include <QPainter>

#include <array>

namespace app {

namespace {

/// The colours of a figure by the names of their classes.
struct NamedColour {
    const char* name;
    QColor FigureColours::*colour;
};
constexpr std::array namedColours{NamedColour{"paper", &FigureColours::paper},
                                  NamedColour{"text", &FigureColours::text},
                                  NamedColour{"muted", &FigureColours::muted},
                                  NamedColour{"rule", &FigureColours::rule},
                                  NamedColour{"border", &FigureColours::border},
                                  NamedColour{"window", &FigureColours::window},
                                  NamedColour{"highlight", &FigureColours::highlight},
                                  NamedColour{"on-highlight", &FigureColours::onHighlight},
                                  NamedColour{"tint", &FigureColours::tint},
                                  NamedColour{"beyond", &FigureColours::beyond}};

/// Colours that are only the numbers of their names.
FigureColours numberedColours()
{
    FigureColours colours;
    for (std::size_t i = 0; i < namedColours.size(); ++i)
        colours.*namedColours[i].colour = QColor(int(i), 0, 0);
    return colours;
}

QByteArray nameOfColour(const QColor& colour)
{
    return namedColours.at(std::size_t(colour.red())).name;
}

} // namespace

FigureFrame svgFrame(const TracedLine& tracedLine, const QSizeF& size)
{
    constexpr int typeSize = 15; // legible where a phone shows the figure at two thirds
    QFont font = QGuiApplication::font();
    font.setPixelSize(typeSize);
    return nearFrame(tracedLine, size, font);
}

QByteArray figureSvg(const TraceStep& at, const QSizeF& size)
{
    SvgDevice device(size, nameOfColour);
    QPainter painter(&device);
    paintStep(painter, at, svgFrame(at.tracedLine, size), numberedColours());
    painter.end();
    return device.elements();
}

std::vector<std::pair<const char*, QColor>> figureClasses(Ground ground)
{
    const FigureColours colours = figureColours(ground);
    std::vector<std::pair<const char*, QColor>> all;
    for (const auto& [name, colour] : namedColours)
        all.emplace_back(name, colours.*colour);
    return all;
}

} // namespace app
