// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/window_options.h"

#include "app/base/number.h"
#include "app/command_line/refusal.h"
#include "app/formats/rectangle_text.h"
#include "app/scene/compared_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

// The origin of lengths with a unit.
Point cornerOf(const Imported& imported)
{
    return imported.paged ? imported.document.page().min : Point{};
}

// Whether an option gives the window.
bool isChosen(const ParsedArguments& arguments)
{
    return arguments.has(QStringLiteral("window")) || arguments.has(QStringLiteral("page"));
}

bool isBare(const Length& length) { return length.unit == Unit::User; }

// Plain numbers and lengths have different origins, so a rectangle of both would be misplaced.
void refuseMixture(const ParsedArguments& arguments, const std::array<Length, 4>& lengths)
{
    if (std::ranges::any_of(lengths, isBare) && !std::ranges::all_of(lengths, isBare))
        throw WrongUsage{
            Commands::tr(
                "--window %1: give all four numbers with a unit, counted from the paper's top left "
                "corner, or all four without a unit, in the drawing's own coordinates.")
                .arg(*arguments.text(QStringLiteral("window")))};
}

// A window without area is valid: it is closed, and keeps what lies on it.
void refuseInverted(const ParsedArguments& arguments, const clipping::Window& window)
{
    const bool beyond = window.min.x > window.max.x, below = window.min.y > window.max.y;
    if (!beyond && !below)
        return;
    if (const auto margin = arguments.text(QStringLiteral("margin")))
        throw WrongUsage{
            Commands::tr("--margin %1 is too large: nothing of the page is left.").arg(*margin)};
    throw WrongUsage{
        beyond ? Commands::tr("The window is inverted: its left edge is beyond its right edge. "
                              "Give XMIN,YMIN,XMAX,YMAX.")
               : Commands::tr("The window is inverted: its top edge is beyond its bottom edge. "
                              "Give XMIN,YMIN,XMAX,YMAX.")};
}

// A length is relative to the paper's corner, a plain number to the drawing's origin.
double placeOf(const Length& length, double corner, double unit)
{
    return isBare(length) ? length.value : corner + toUserUnits(length, unit);
}

} // namespace

std::vector<Option> windowOptions()
{
    return {
        {{"w", "window"},
         "XMIN,YMIN,XMAX,YMAX",
         Commands::tr("The clip window. Bare numbers are the drawing's own coordinates; lengths "
                      "with a unit, such as 10mm, count from the paper's top left corner. The two "
                      "cannot be mixed (the drawing's clip windows, otherwise its page).")},
        {{"page"}, {}, Commands::tr("Use the drawing's page as the clip window.")},
        {{"margin"},
         "LENGTH",
         Commands::tr("With --page: make the window this much smaller on each side.")},
    };
}

clipping::Window windowOf(const Imported& imported)
{
    const Page& page = imported.document.page();
    const ComparedWindow saved = comparedWindow(imported.document.windows(), page);
    return saved.isPage ? imported.drawn.value_or(page.rectangle()) : saved.window;
}

clipping::Window windowOf(const ParsedArguments& arguments, const Imported& imported)
{
    const Page& page = imported.document.page();
    const double unit = page.millimetresPerUnit();
    const auto margin = arguments.length(QStringLiteral("margin"));
    if (margin && !arguments.has(QStringLiteral("page")))
        throw WrongUsage{Commands::tr("--margin needs --page: it makes the page smaller.")};
    clipping::Window window = windowOf(imported);
    if (const auto r = arguments.rectangle(QStringLiteral("window"))) {
        if (arguments.has(QStringLiteral("page")))
            throw WrongUsage{Commands::tr("Give either --window or --page, not both.")};
        refuseMixture(arguments, *r);
        const Point corner = cornerOf(imported);
        const auto place = [&](std::size_t i) {
            return placeOf((*r)[i], i % 2 == 0 ? corner.x : corner.y, unit);
        };
        window = {{place(0), place(1)}, {place(2), place(3)}};
    } else if (arguments.has(QStringLiteral("page"))) {
        const double less = margin ? toUserUnits(*margin, unit) : 0;
        window = {page.min + less, page.min + page.size - less};
    }
    for (const double number : {window.min.x, window.min.y, window.max.x, window.max.y})
        if (!std::isfinite(number))
            throw WrongUsage{Commands::tr("The window is too large for this drawing's unit: give "
                                          "smaller lengths.")};
    refuseInverted(arguments, window);
    return window;
}

ClipWindows windowsOf(const ParsedArguments& arguments, const Imported& imported)
{
    const ClipWindows& saved = imported.document.windows();
    const clipping::Window window = windowOf(arguments, imported); // throws for invalid options
    if (!isChosen(arguments) && cuts(saved))
        return saved;
    return {{{.shape = RectangleShape{window}}}};
}

namespace {

QString operationText(WindowOperation operation)
{
    return operation == WindowOperation::Add      ? Commands::tr("add %1")
           : operation == WindowOperation::CutOut ? Commands::tr("cut out %1")
                                                  : Commands::tr("intersect %1");
}

QString stepText(const ClipRegion::Step& step, const Imported& imported)
{
    const QString place = placeText(step.box, imported);
    return step.rings.empty() ? place : Commands::tr("a shape within %1").arg(place);
}

QString sourceText(const ParsedArguments& arguments, const Imported& imported)
{
    const auto margin = arguments.text(QStringLiteral("margin"));
    if (arguments.has(QStringLiteral("window")))
        return Commands::tr("given");
    if (margin)
        return Commands::tr("the page, margin %1").arg(*margin);
    if (arguments.has(QStringLiteral("page")))
        return Commands::tr("the page");
    if (cuts(imported.document.windows()))
        return Commands::tr("saved in the drawing");
    if (!imported.paged && imported.document.objects().empty())
        return Commands::tr("the default page, because the drawing is empty");
    return imported.drawn || !imported.paged ? Commands::tr("the bounds of all objects")
                                             : Commands::tr("the page");
}

} // namespace

QString windowText(const ParsedArguments& arguments, const Imported& imported,
                   const ClipRegion& region)
{
    const QString source = sourceText(arguments, imported);
    const QString keeps = region.keep == Keep::Outside
                              ? QStringLiteral("; ") + Commands::tr("keeps the outside")
                              : QString();
    if (const auto window = region.single())
        return Commands::tr("Window (%1): %2%3.").arg(source, placeText(*window, imported), keeps);
    QStringList steps;
    for (const ClipRegion::Step& step : region.steps)
        steps << operationText(step.operation).arg(stepText(step, imported));
    return Commands::tr("Windows (%1): %2%3.").arg(source, steps.join(QStringLiteral("; ")), keeps);
}

QString placeText(const clipping::Window& rectangle, const Imported& imported)
{
    const QString text =
        Commands::tr("%1 in the drawing's coordinates").arg(rectangleText(rectangle));
    const bool inMillimetres =
        imported.document.page().millimetresPerUnit() == 1 && cornerOf(imported) == Point{};
    return inMillimetres ? text : text + QStringLiteral(", ") + millimetreText(rectangle, imported);
}

QString millimetreText(const clipping::Window& rectangle, const Imported& imported)
{
    constexpr int decimals = 3; // a micrometre
    constexpr double most = std::numeric_limits<double>::max();
    const double unit = imported.document.page().millimetresPerUnit();
    const Point corner = cornerOf(imported);
    const Point min = (rectangle.min - corner) * unit, max = (rectangle.max - corner) * unit;
    std::string numbers;
    for (const double number : {min.x, min.y, max.x, max.y}) {
        appendNumber(numbers, std::clamp(number, -most, most), decimals, -most, most);
        numbers += "mm,";
    }
    numbers.pop_back();
    return (imported.paged ? Commands::tr("%1 from the paper's top left corner")
                           : Commands::tr("%1 from the origin"))
        .arg(QString::fromStdString(numbers));
}

} // namespace app
