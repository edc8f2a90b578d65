// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/window_options.h"

#include "app/command_line/refusal.h"

namespace app {

std::vector<Option> windowOptions()
{
    return {
        {{"w", "window"},
         "XMIN,YMIN,XMAX,YMAX",
         Commands::tr("The clip window: numbers in the drawing's units, or lengths such as 10mm "
                      "(without: the drawing's own clip window, or else its page).")},
        {{"page"}, {}, Commands::tr("The clip window is the drawing's page.")},
        {{"margin"}, "LENGTH", Commands::tr("With --page: that much smaller on each side.")},
    };
}

clipping::Window windowOf(const Given& given, const Sheet& sheet)
{
    const double unit = sheet.page.millimetresPerUnit();
    const auto margin = given.length(QStringLiteral("margin"));
    if (margin && !given.has(QStringLiteral("page")))
        throw WrongUsage{Commands::tr("--margin needs --page: it makes the page smaller.")};
    clipping::Window window = sheet.window;
    if (const auto r = given.rectangle(QStringLiteral("window"))) {
        if (given.has(QStringLiteral("page")))
            throw WrongUsage{Commands::tr("Give either --window or --page, not both.")};
        const auto units = [&](std::size_t i) { return toUserUnits((*r)[i], unit); };
        window = {{units(0), units(1)}, {units(2), units(3)}};
    } else if (given.has(QStringLiteral("page"))) {
        const double less = margin ? toUserUnits(*margin, unit) : 0;
        window = {sheet.page.min + less, sheet.page.min + sheet.page.size - less};
    }
    if (window.min.x > window.max.x || window.min.y > window.max.y)
        throw WrongUsage{Commands::tr("The window is empty: its XMIN,YMIN must not be greater than "
                                      "its XMAX,YMAX.")};
    return window;
}

} // namespace app
