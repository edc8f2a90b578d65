// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/window_forms.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/drawing_files.h"
#include "app/command_line/drawing_numbers.h"
#include "app/command_line/nearest.h"
#include "app/document/recipe_outline.h"
#include "app/document/window_shape.h"

#include <QRegularExpression>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>

namespace app {
namespace {

using Windows = std::vector<ClipWindow>;

Windows one(WindowShape shape) { return {{.shape = std::move(shape)}}; }

// A window without area is valid, and contains nothing.
void refuseInverted(const clipping::Window& window)
{
    const bool beyond = window.min.x > window.max.x, below = window.min.y > window.max.y;
    if (beyond || below)
        throw WrongUsage{
            beyond ? Text::tr("The window is inverted: its left edge is beyond its right edge. "
                              "Give XMIN,YMIN,XMAX,YMAX.")
                   : Text::tr("The window is inverted: its top edge is beyond its bottom edge. "
                              "Give XMIN,YMIN,XMAX,YMAX.")};
}

// XMIN,YMIN,XMAX,YMAX[@DEGREES], counterclockwise about its centre.
Windows rectangle(const GivenValue& value, const QString& text, const Imported& imported)
{
    const QString expected = Text::tr(
        "four lengths XMIN,YMIN,XMAX,YMAX such as -100,-75,100,75 or 0,0,10cm,70mm, and @DEGREES "
        "after them to rotate the window");
    const QStringList parts = text.split(u'@');
    const DrawingNumbers numbers(value, parts.front(), expected, imported);
    bool isAngle = true;
    const double degrees = parts.size() < 2 ? 0 : parts[1].trimmed().toDouble(&isAngle);
    if (numbers.size() != 4 || parts.size() > 2 || !isAngle || !std::isfinite(degrees))
        refuse(value, expected);
    const clipping::Window box{numbers.point(0), numbers.point(2)};
    refuseInverted(box);
    return one(rotated(RectangleShape{box}, -glm::radians(degrees)));
}

Windows page(const GivenValue&, const QString&, const Imported& imported)
{
    return one(RectangleShape{imported.document.page().rectangle()});
}

WindowShape ellipse(const Point& centre, const Point& radii)
{
    const EllipseRecipe recipe{centre, radii};
    const auto outline = outlineOf(recipe);
    return PathShape{Path({&*outline, 1}), FillRule::NonZero, recipe};
}

Windows circle(const GivenValue& value, const QString& text, const Imported& imported)
{
    const QString expected =
        Text::tr("the centre and a radius greater than 0 such as circle:50mm,50mm,20mm");
    const DrawingNumbers numbers(value, text, expected, imported);
    if (numbers.size() != 3 || !(numbers.length(2) > 0))
        refuse(value, expected);
    return one(ellipse(numbers.point(0), Point(numbers.length(2))));
}

Windows polygon(const GivenValue& value, const QString& text, const Imported& imported)
{
    const QString expected = Text::tr("three or more corners such as “polygon:0,0 10,0 5,8”");
    static const QRegularExpression afterComma(QStringLiteral("\\s*,\\s*")),
        between(QStringLiteral("[\\s;]+"));
    const QStringList corners =
        QString(text).trimmed().replace(afterComma, QStringLiteral(",")).split(between);
    const DrawingNumbers numbers(value, corners.join(u','), expected, imported);
    const bool paired =
        std::ranges::all_of(corners, [](const QString& corner) { return corner.count(u',') == 1; });
    if (!paired || corners.size() < 3)
        refuse(value, expected);
    Subpath ring{numbers.point(0), {}, true};
    for (std::size_t i = 2; i < numbers.size(); i += 2)
        ring.segments.push_back({numbers.point(i)});
    return one(PathShape{Path({&ring, 1})});
}

// The shapes of some objects, those that enclose something.
Windows windowsOf(const Document& drawing, const ObjectRange& range)
{
    Windows windows;
    for (std::size_t i = range.first; i < range.end; ++i)
        if (auto window = windowOf(drawing.objects()[i]))
            windows.push_back(*window);
    return windows;
}

void refuseNothing(const GivenValue& value, const Windows& windows)
{
    if (windows.empty())
        throw WrongUsage{Text::tr("--%1 %2: nothing there encloses an area. Choose a closed "
                                  "shape, or a path of several lines.")
                             .arg(value.option, value.text)};
}

// "“a”, “b”": the first ones.
QString firstNames(const QStringList& names)
{
    constexpr qsizetype most = 10;
    QStringList quoted;
    for (const QString& name : names.first(std::min(most, names.size())))
        quoted << u'“' + name + u'”';
    if (names.size() > most)
        quoted << Text::tr("%1 more").arg(names.size() - most);
    return quoted.join(Text::tr(", "));
}

[[noreturn]] void refuseName(const GivenValue& value, const QString& name, const QStringList& names,
                             const QString& nothing)
{
    const auto nearest = nearestTo(name, names);
    throw WrongUsage{
        Text::tr("--%1 %2: ").arg(value.option, value.text)
        + (names.isEmpty() ? nothing
           : nearest
               ? Text::tr("there is no “%1” in the drawing. Did you mean “%2”?").arg(name, *nearest)
               : Text::tr("there is no “%1” in the drawing, which has %2.")
                     .arg(name, firstNames(names)))};
}

Windows shapesOfObjects(const GivenValue& value, const Document& drawing, const ObjectRange& range)
{
    Windows windows = windowsOf(drawing, range);
    refuseNothing(value, windows);
    return windows;
}

// An object, the objects of a group or layer, or a clip path of the file.
Windows shape(const GivenValue& value, const QString& id, const Imported& imported)
{
    const Document& drawing = imported.document;
    QStringList ids;
    for (std::size_t i = 0; i < drawing.objects().size(); ++i) {
        const QString& here = drawing.objects()[i].particulars().id;
        if (here == id && !id.isEmpty())
            return shapesOfObjects(value, drawing, {i, i + 1});
        if (!here.isEmpty())
            ids << here;
    }
    for (const ContainerId each : drawing.containers().inOrder()) {
        const QString& here = drawing.containers()[each].svgId;
        if (here == id && !id.isEmpty())
            return shapesOfObjects(value, drawing, drawing.containers().rangeOf(each));
        if (!here.isEmpty())
            ids << here;
    }
    for (const NamedArea& each : imported.clipPaths) {
        if (each.id == id && !id.isEmpty()) {
            refuseNothing(value, each.windows);
            return each.windows;
        }
        ids << each.id;
    }
    refuseName(value, id, ids, Text::tr("no shape of the drawing has an id."));
}

Windows layer(const GivenValue& value, const QString& name, const Imported& imported)
{
    const Containers& tree = imported.document.containers();
    QStringList names;
    for (const ContainerId id : tree.inOrder()) {
        if (tree[id].kind != Container::Kind::Layer)
            continue;
        if (tree[id].name == name)
            return shapesOfObjects(value, imported.document, tree.rangeOf(id));
        names << tree[id].name;
    }
    refuseName(value, name, names, Text::tr("the drawing has no layer."));
}

// A mask is laid on the drawing with the corners of both papers together, at its size in
// millimetres.
Windows mask(const GivenValue& value, const QString& path, const Imported& imported)
{
    const Imported mask = readDrawing(path);
    Windows windows = windowsOf(mask.document, {0, mask.document.objects().size()});
    refuseNothing(value, windows);
    const double scale =
        mask.document.page().millimetresPerUnit() / imported.document.page().millimetresPerUnit();
    const AffineMap onto{{scale, 0}, {0, scale}, cornerOf(mask), cornerOf(imported)};
    for (ClipWindow& window : windows)
        window.shape = mapped(window.shape, onto);
    return windows;
}

constexpr std::array forms{
    WindowForm{"", "XMIN,YMIN,XMAX,YMAX[@DEGREES]", rectangle},
    WindowForm{"circle", "circle:CX,CY,R", circle},
    WindowForm{"polygon", "polygon:X,Y X,Y …", polygon},
    WindowForm{"shape", "shape:ID", shape, true},
    WindowForm{"layer", "layer:NAME", layer, true},
    WindowForm{"file", "file:MASK.svg", mask},
    WindowForm{"page", "page", page, true},
};

} // namespace

std::span<const WindowForm> windowForms() { return forms; }

static const WindowForm* formOf(const GivenValue& value)
{
    const QString key = value.text.section(u':', 0, 0);
    const auto* form = std::ranges::find(forms, key.toStdString(), &WindowForm::key);
    return form == forms.end() ? nullptr : form;
}

bool needsDrawing(const GivenValue& value)
{
    const auto* form = formOf(value);
    return form && form->needsDrawing;
}

std::vector<ClipWindow> windowsOf(const GivenValue& value, const Imported& imported)
{
    if (const auto* form = formOf(value))
        return form->windows(value, value.text.section(u':', 1), imported);
    if (value.text.contains(u':')) {
        QStringList usages;
        for (const WindowForm& each : forms)
            usages << QString::fromUtf8(each.usage);
        refuse(value, usages.join(QStringLiteral(", ")));
    }
    return rectangle(value, value.text, imported);
}

} // namespace app
