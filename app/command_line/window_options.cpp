// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/window_options.h"

#include "app/base/number.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/drawing_numbers.h"
#include "app/command_line/window_forms.h"
#include "app/document/window_operations.h"
#include "app/formats/coordinates.h"
#include "app/scene/area_windows.h"
#include "app/scene/compared_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

// The options that give clip windows.
constexpr struct {
    const char* option;
    WindowOperation operation;
} givers[]{{"window", WindowOperation::Add},
           {"page", WindowOperation::Add},
           {"cut-out", WindowOperation::CutOut},
           {"intersect", WindowOperation::Intersect},
           {"replace", WindowOperation::Replace}};

std::vector<GivenValue> given(const ParsedArguments& arguments)
{
    QStringList options;
    for (const auto& giver : givers)
        options << QString::fromLatin1(giver.option);
    return arguments.inOrder(options);
}

// The page, smaller by the margin.
clipping::Window pageOf(const ParsedArguments& arguments, const Imported& imported)
{
    const Page& page = imported.document.page();
    const auto margin = arguments.length(QStringLiteral("margin"));
    const double less = margin ? toUserUnits(*margin, page.millimetresPerUnit()) : 0;
    const clipping::Window window{page.min + less, page.min + page.size - less};
    for (const double number : {window.min.x, window.min.y, window.max.x, window.max.y})
        if (!std::isfinite(number))
            throw WrongUsage{Text::tr("The window is too large for this drawing's unit: give "
                                      "smaller lengths.")};
    if (window.min.x > window.max.x || window.min.y > window.max.y)
        throw WrongUsage{Text::tr("--margin %1 is too large: nothing of the page is left.")
                             .arg(*arguments.text(QStringLiteral("margin")))};
    return window;
}

void refuseContradictions(const ParsedArguments& arguments)
{
    const bool page = arguments.has(QStringLiteral("page"));
    if (arguments.has(QStringLiteral("margin")) && !page)
        throw WrongUsage{Text::tr("--margin needs --page: it makes the page smaller.")};
    if (arguments.has(QStringLiteral("window")) && page)
        throw WrongUsage{Text::tr("Give either --window or --page, not both. To add the page to "
                                  "other windows, write --window page.")};
}

// A list of windows has no brackets: each of several shapes would intersect the others.
void uniteIfNeeded(std::vector<ClipWindow>& shapes, const GivenValue& value, const Page& page)
{
    const bool intersects = value.option == QLatin1StringView("intersect");
    if (shapes.size() > ClipWindows::most || (intersects && shapes.size() > 1))
        shapes = {{.shape = united(shapes, page)}};
}

std::vector<ClipWindow> givenShapes(const GivenValue& value, const ParsedArguments& arguments,
                                    const Imported& imported)
{
    if (value.option != QLatin1StringView("page"))
        return windowsOf(value, imported);
    // Not within the braces: of an aggregate that an exception leaves half made, g++ 12 destroys
    // members that it has not made.
    const clipping::Window page = pageOf(arguments, imported);
    return {{.shape = RectangleShape{page}}};
}

ClipWindows givenWindows(const ParsedArguments& arguments, const Imported& imported)
{
    refuseContradictions(arguments);
    ClipWindows windows;
    for (const GivenValue& value : given(arguments)) {
        const auto* giver = std::ranges::find(
            givers, value.option, [](const auto& each) { return QLatin1StringView(each.option); });
        auto shapes = givenShapes(value, arguments, imported);
        uniteIfNeeded(shapes, value, imported.document.page());
        WindowOperation operation = giver->operation;
        for (ClipWindow& window : shapes) {
            window.operation = operation;
            windows.list.push_back(std::move(window));
            if (operation == WindowOperation::Replace)
                operation = WindowOperation::Add; // or each would replace the shape before it
        }
    }
    if (windows.list.size() > ClipWindows::most)
        throw WrongUsage{Text::tr("There are %1 clip windows. A drawing can have %2.")
                             .arg(windows.list.size())
                             .arg(ClipWindows::most)};
    return windows;
}

} // namespace

std::vector<Option> windowOptions()
{
    return {
        {{"w", "window"},
         "XMIN,YMIN,XMAX,YMAX",
         Text::tr("The clip window. Bare numbers are the drawing's own coordinates. Lengths with a "
                  "unit, such as 10mm or 2.5m, are real lengths at the drawing's scale, and count "
                  "from the paper's top left corner. The two cannot be mixed (the drawing's clip "
                  "windows, otherwise its page).")},
        {{"page"}, {}, Text::tr("Use the drawing's page as the clip window.")},
        {{"margin"},
         "LENGTH",
         Text::tr("With --page: make the window this much smaller on each side.")},
    };
}

std::vector<Option> shapedWindowOptions()
{
    std::vector<Option> options = windowOptions();
    QStringList forms;
    for (const WindowForm& form : windowForms())
        forms << QString::fromUtf8(form.usage);
    options.front().value = QStringLiteral("WINDOW");
    options.front().meaning =
        Text::tr("A clip window: %1. Bare numbers are the drawing's own coordinates. Lengths with "
                 "a unit, such as 10mm or 2.5m, are real lengths at the drawing's scale, and count "
                 "from the paper's top left corner. May be given several times: each adds to what "
                 "those before it keep (the drawing's clip windows, otherwise its page).")
            .arg(forms.join(QStringLiteral(", ")));
    const std::vector<Option> more{
        {{"cut-out"}, "WINDOW", Text::tr("Cut this window out of what those before it keep.")},
        {{"intersect"},
         "WINDOW",
         Text::tr("Keep only what this window and those before it have in common.")},
        {{"replace"},
         "WINDOW",
         Text::tr("Let this window take the place of those before it, which have no effect "
                  "then.")}};
    options.insert(options.begin() + 1, more.begin(), more.end());
    return options;
}

std::vector<Option> comparedWindowOptions()
{
    std::vector<Option> options = windowOptions();
    options.front().value = QStringLiteral("WINDOW");
    options.front().meaning = Text::tr(
        "The clip window: a rectangle XMIN,YMIN,XMAX,YMAX, with @DEGREES to rotate it. Or a convex "
        "polygon, as for clip: circle:CX,CY,R or polygon:X,Y X,Y .... Without it: the drawing's "
        "first clip window that is a rectangle along the axes, otherwise its page.");
    return options;
}

clipping::Window windowOf(const Imported& imported)
{
    const Page& page = imported.document.page();
    const ComparedWindow saved = comparedWindow(imported.document.windows(), page);
    return saved.isPage ? imported.drawn.value_or(page.rectangle()) : saved.window;
}

bool windowsNeedNoDrawing(const ParsedArguments& arguments)
{
    const auto all = given(arguments);
    return !all.empty() && std::ranges::none_of(all, [](const GivenValue& value) {
        return value.option == u"page" || needsDrawing(value);
    });
}

ClipWindows comparedWindowsOf(const ParsedArguments& arguments, const Imported& imported)
{
    ClipWindows windows = givenWindows(arguments, imported);
    if (windows.list.empty())
        return {{{.shape = RectangleShape{windowOf(imported)}}}};
    if (windows.list.size() > 1)
        throw WrongUsage{Text::tr("Algorithms are compared at one window, and these are %1: "
                                  "give one.")
                             .arg(windows.list.size())};
    return windows;
}

ClipWindows windowsOf(const ParsedArguments& arguments, const Imported& imported)
{
    ClipWindows windows = givenWindows(arguments, imported);
    if (!windows.list.empty())
        return windows;
    if (cuts(imported.document.windows()))
        return imported.document.windows();
    return {{{.shape = RectangleShape{windowOf(imported)}}}};
}

namespace {

QString stepText(const ClipRegion::Step& step, const Imported& imported)
{
    if (!(step.box.min.x <= step.box.max.x))
        return Text::tr("a window without area, which contains nothing");
    const QString place = placeText(step.box, imported);
    return step.rings.empty() ? place : Text::tr("a shape within %1").arg(place);
}

QString sourceText(const ParsedArguments& arguments, const Imported& imported)
{
    const auto margin = arguments.text(QStringLiteral("margin"));
    const auto all = given(arguments);
    if (std::ranges::any_of(all, [](const auto& v) { return v.option != u"page"; }))
        return Text::tr("given");
    if (margin)
        return Text::tr("the page, margin %1").arg(*margin);
    if (arguments.has(QStringLiteral("page")))
        return Text::tr("the page");
    if (cuts(imported.document.windows()))
        return Text::tr("saved in the drawing");
    if (!imported.paged && imported.document.objects().empty())
        return Text::tr("the default page, because the drawing is empty");
    return imported.drawn || !imported.paged ? Text::tr("the bounds of all objects")
                                             : Text::tr("the page");
}

} // namespace

QString windowText(const ParsedArguments& arguments, const Imported& imported,
                   const ClipRegion& region)
{
    const QString source = sourceText(arguments, imported);
    const QString keeps = region.keep == Keep::Outside
                              ? QStringLiteral("; ") + Text::tr("keeps the outside")
                              : QString();
    if (region.single())
        return Text::tr("Window (%1): %2%3.")
            .arg(source, stepText(region.steps.front(), imported), keeps);
    QStringList steps;
    for (const ClipRegion::Step& step : region.steps)
        steps << infoOf(step.operation).phrase.arg(stepText(step, imported));
    return Text::tr("Windows (%1): %2%3.").arg(source, steps.join(QStringLiteral("; ")), keeps);
}

QString placeText(const clipping::Window& rectangle, const Imported& imported)
{
    const QString text = Text::tr("%1 in the drawing's coordinates").arg(rectangleText(rectangle));
    const bool inMillimetres =
        imported.document.page().realMillimetresPerUnit() == 1 && cornerOf(imported) == Point{};
    return inMillimetres ? text : text + QStringLiteral(", ") + millimetreText(rectangle, imported);
}

QString millimetreText(const clipping::Window& rectangle, const Imported& imported)
{
    constexpr int decimals = 3; // a micrometre
    constexpr double most = std::numeric_limits<double>::max();
    const double unit = imported.document.page().realMillimetresPerUnit();
    const Point corner = cornerOf(imported);
    const Point min = (rectangle.min - corner) * unit, max = (rectangle.max - corner) * unit;
    std::string numbers;
    for (const double number : {min.x, min.y, max.x, max.y}) {
        appendNumber(numbers, std::clamp(number, -most, most), decimals, -most, most);
        numbers += "mm,";
    }
    numbers.pop_back();
    return (imported.paged ? Text::tr("%1 from the paper's top left corner")
                           : Text::tr("%1 from the origin"))
        .arg(QString::fromStdString(numbers));
}

} // namespace app
