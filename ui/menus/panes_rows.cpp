// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/menus/next_part.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

template <std::size_t count>
void showPanes(MainWindow& window)
{
    app::Panes panes = window.canvas().panes();
    panes.show(count);
    window.canvas().setPanes(panes);
}

template <std::size_t count>
bool showsPanes(const MainWindow& window)
{
    return window.canvas().panes().size() == count;
}

void showAllPanes(MainWindow& window)
{
    app::Panes panes = window.canvas().panes();
    panes.showAll();
    window.canvas().setPanes(panes);
}

bool severalPanes(const MainWindow& window) { return window.canvas().panes().size() > 1; }

void closePane(MainWindow& window)
{
    app::Panes panes = window.canvas().panes();
    panes.close(panes.active());
    window.canvas().setPanes(panes);
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
std::vector<ActionInfo> panesRows()
{
    return {
        {
            .key = "panes-1",
            .text = Text::tr("&One pane"),
            .keys = {QKeySequence("Ctrl+1")},
            .run = showPanes<1>,
            .checked = showsPanes<1>,
            .group = "panes",
        },
        {
            .key = "panes-2",
            .text = Text::tr("&Two panes"),
            .keys = {QKeySequence("Ctrl+2")},
            .run = showPanes<2>,
            .checked = showsPanes<2>,
            .group = "panes",
        },
        {
            .key = "panes-4",
            .text = Text::tr("&Four panes"),
            .keys = {QKeySequence("Ctrl+4")},
            .icon = "panes",
            .run = showPanes<4>,
            .checked = showsPanes<4>,
            .group = "panes",
        },
        {
            .key = "panes-all",
            .text = Text::tr("A pane for &every algorithm"),
            .keys = {QKeySequence("Ctrl+9")},
            .run = showAllPanes,
            .checked = [](const MainWindow& w) { return w.canvas().panes().showsAll(); },
            .group = "panes",
        },
        {
            .key = "next-pane",
            .text = Text::tr("&Next pane, bar or panel"),
            .keys = {QKeySequence("F6")},
            .run = [](MainWindow& w) { goToNextPart(w, 1); },
        },
        {
            .key = "previous-pane",
            .text = Text::tr("&Previous pane, bar or panel"),
            .keys = {QKeySequence("Shift+F6")},
            .run = [](MainWindow& w) { goToNextPart(w, -1); },
        },
        {
            .key = "close-pane",
            .text = Text::tr("&Close pane"),
            .keys = {QKeySequence("Ctrl+Shift+W")},
            .run = closePane,
            .enabled = severalPanes,
        },
    };
}

} // namespace ui
