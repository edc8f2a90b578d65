// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/drawing_files.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"
#include "app/document/contents.h"
#include "app/document/flatten.h"
#include "app/document/hidden_objects.h"
#include "app/document/window_operations.h"
#include "app/formats/coordinates.h"
#include "app/formats/painted.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace app {
namespace {

// Replaces a number that differs from a short one only by rounding errors: 3.3 for
// 3.3000000000000003. 0.3333333333333333 stays.
double withoutNoise(double value)
{
    constexpr int digits = 12;
    constexpr double noise = 4 * std::numeric_limits<double>::epsilon();
    const double near = QString::number(value, 'g', digits).toDouble();
    return std::abs(near - value) <= noise * std::abs(value) ? near : value;
}

QString calculated(const clipping::Window& box)
{
    const auto& [min, max] = box;
    return rectangleText(
        {{withoutNoise(min.x), withoutNoise(min.y)}, {withoutNoise(max.x), withoutNoise(max.y)}});
}

// A sum, which may have overflowed.
QString rounded(double value)
{
    constexpr double most = std::numeric_limits<double>::max();
    constexpr int decimals = 3;
    std::string number;
    appendNumber(number, std::min(value, most), decimals, 0, most);
    return QString::fromStdString(number);
}

QString text(const Length& length)
{
    return shortestText(length.value) + QLatin1StringView(infoOf(length.unit).suffix);
}

// "on paper 297mm × 210mm". A page may have its size in units alone.
QString paperText(const Page& page)
{
    const auto isOpen = [](const Length& length) {
        return !(infoOf(length.unit).millimetres > 0 && length.value > 0);
    };
    if (isOpen(page.width) && isOpen(page.height))
        return Text::tr("without a size on paper: a unit counts as a pixel");
    const Point paper = paperOf(page).millimetres;
    const auto side = [&](const Length& length, double millimetres) {
        return isOpen(length) ? rounded(millimetres) + QStringLiteral("mm") : text(length);
    };
    return Text::tr("on paper %1 × %2").arg(side(page.width, paper.x), side(page.height, paper.y));
}

using Rows = std::vector<std::pair<QString, QString>>;

QString stateOf(const Container& container)
{
    QString image;
    if (const SharedUnderlay& under = container.underlay)
        image =
            Text::tr(", image of %1 × %2 pixels").arg(under->file->width).arg(under->file->height);
    return image + (container.visible ? QString() : Text::tr(", hidden"))
           + (container.locked ? Text::tr(", locked") : QString());
}

// Groups from other programs may have no name.
QString nameOf(const Container& container)
{
    return container.name.isEmpty() ? container.svgId : container.name;
}

// The index of each object's first line among all lines, and the end.
std::vector<std::size_t> linesBefore(const Document& document, Contents& all)
{
    const Objects& objects = document.objects();
    const double tolerance = usualTolerance(document.page());
    std::vector<std::size_t> before{0};
    before.reserve(objects.size() + 1);
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        add(all, object, tolerance);
        before.push_back(all.lines);
    });
    return before;
}

// Each container with its contents and those of its children, which follow with more indent.
Rows containerRows(const Containers& containers, std::span<const std::size_t> linesBefore)
{
    Rows rows;
    for (const ContainerId id : containers.inOrder()) {
        const Container& container = containers[id];
        const ObjectRange range = containers.rangeOf(id);
        const QString indent(qsizetype{2} * (containers.depthOf(id) - 1), u' ');
        rows.emplace_back(container.kind == Container::Kind::Layer ? Text::tr("layer")
                                                                   : Text::tr("group"),
                          indent
                              + Text::tr("“%1”: shapes %2, lines %3%4")
                                    .arg(nameOf(container))
                                    .arg(range.size())
                                    .arg(linesBefore[range.end] - linesBefore[range.first])
                                    .arg(stateOf(container)));
    }
    return rows;
}

QString turnedText(const QString& text, double angle)
{
    return angle == 0 ? text
                      : Text::tr("%1 turned by %2°")
                            .arg(text, shortestText(withoutNoise(angle * 180 / std::numbers::pi)));
}

QString pathText(const PathShape& shape)
{
    if (const auto* ellipse = std::get_if<EllipseRecipe>(&shape.recipe)) {
        const auto& [centre, radii, turn] = *ellipse;
        return turnedText(Text::tr("ellipse about (%1, %2) with the radii %3 and %4")
                              .arg(shortestText(centre.x), shortestText(centre.y),
                                   shortestText(radii.x), shortestText(radii.y)),
                          turn);
    }
    const auto parts = shape.path.subpaths();
    std::size_t segments = 0;
    for (const Subpath& part : parts)
        segments += part.segments.size();
    return Text::tr("path of %1 segments in %2 parts").arg(segments).arg(parts.size());
}

QString shapeText(const WindowShape& shape)
{
    if (const auto* own = std::get_if<PathShape>(&shape))
        return pathText(*own);
    const auto& [box, angle] = std::get<RectangleShape>(shape);
    return turnedText(rectangleText(box), angle);
}

// A window that is only a rectangle is described by its numbers alone.
QString windowText(const ClipWindows& windows, std::size_t number)
{
    const ClipWindow& window = windows.list[number];
    const bool only = windows.list.size() == 1;
    QString text = window.name.isEmpty() ? QString() : Text::tr("“%1”: ").arg(window.name);
    text += shapeText(window.shape);
    if (!only || window.operation != WindowOperation::Add)
        text += QStringLiteral(", ") + infoOf(window.operation).verb;
    return text
           + (!window.visible              ? Text::tr(", hidden")
              : replacing(windows, number) ? Text::tr(", without effect: a later one replaces it")
                                           : QString());
}

Rows windowRows(const ClipWindows& windows)
{
    if (windows.list.empty())
        return {{Text::tr("window"), Text::tr("none")}};
    Rows rows;
    for (std::size_t number = 0; number < windows.list.size(); ++number)
        rows.emplace_back(Text::tr("window"), windowText(windows, number));
    if (windows.keep == Keep::Outside)
        rows.emplace_back(Text::tr("keep"), Text::tr("outside"));
    return rows;
}

Rows paperRows(const Page& page)
{
    const auto inMillimetres = [](double length) {
        return shortestText(withoutNoise(length)) + QStringLiteral("mm");
    };
    Rows rows{
        {Text::tr("page"), Text::tr("%1, %2").arg(calculated(page.rectangle()), paperText(page))},
        {Text::tr("unit"), inMillimetres(page.millimetresPerUnit())},
    };
    if (page.scale.ratio != 1)
        rows.emplace_back(
            Text::tr("scale"),
            Text::tr("1:%1, a unit is %2 of the real thing")
                .arg(shortestText(page.scale.ratio), inMillimetres(page.realMillimetresPerUnit())));
    if (page.scale.unit)
        rows.emplace_back(Text::tr("lengths in"),
                          QLatin1StringView(infoOf(*page.scale.unit).suffix));
    return rows;
}

Rows infoRows(const Imported& imported)
{
    const Document& document = imported.document;
    const Page& page = document.page();
    Contents all;
    const std::vector<std::size_t> lines = linesBefore(document, all);
    const double unit = page.millimetresPerUnit();
    Rows rows{
        {Text::tr("lines"), QString::number(all.lines)},
        {Text::tr("length"),
         Text::tr("%1, on paper %2mm").arg(rounded(all.length), rounded(all.length * unit))},
        {Text::tr("shapes"),
         Text::tr("%1, hidden %2").arg(all.objects).arg(hiddenObjects(document).size())},
        {Text::tr("paths"), Text::tr("%1, closed %2, curves %3")
                                .arg(all.subpaths)
                                .arg(all.closedSubpaths)
                                .arg(all.curves)},
        {Text::tr("bounds"), all.bounds ? calculated(*all.bounds) : Text::tr("none")},
        {Text::tr("in mm"), all.bounds ? millimetreText(*all.bounds, imported) : Text::tr("none")},
    };
    for (auto& row : windowRows(document.windows()))
        rows.push_back(std::move(row));
    for (const Rows& more : {paperRows(page), containerRows(document.containers(), lines)})
        rows.insert(rows.end(), more.begin(), more.end());
    const QStringList lost = losses(imported.report);
    for (const QString& line : lost)
        rows.emplace_back(Text::tr("import"), line);
    return rows;
}

void inform(const ParsedArguments& arguments)
{
    print(inColumns(infoRows(readDrawing(arguments, arguments.operands().first()))));
}

} // namespace

Command infoCommand()
{
    return {"info",
            "INPUT [OPTIONS]",
            Text::tr("Lists the content of a drawing: lines and their length, shapes, paths, "
                     "curves, bounds (also in millimetres). Then clip windows, page, unit, layers "
                     "and groups, and what cannot be kept."),
            readingOptions(),
            {"clearcut info drawing.svg"},
            1,
            inform,
            Paints::Letters,
            readingLimits()};
}

} // namespace app
