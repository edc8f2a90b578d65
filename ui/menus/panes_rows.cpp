// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"
#include "ui/docks/dock.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

#include <QApplication>

#include <algorithm>

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

void closePane(MainWindow& window) { window.canvas().closePane(window.canvas().panes().active()); }

/// The first part of a widget, in the order of the Tab key, that takes the keyboard; null: none.
QWidget* firstStop(QWidget& inside)
{
    for (QWidget* one = inside.nextInFocusChain(); one != &inside; one = one->nextInFocusChain())
        if (inside.isAncestorOf(one) && one->isVisible() && one->isEnabled()
            && (one->focusPolicy() & Qt::TabFocus) && !one->focusProxy())
            return one;
    return nullptr;
}

QList<Dock*> column(const MainWindow& window)
{
    QList<Dock*> docks;
    for (Dock* dock : window.findChildren<Dock*>())
        if (dock->isVisible() && !dock->isBehind())
            docks << dock;
    std::ranges::sort(docks, {}, [](const Dock* dock) { return dock->y(); });
    return docks;
}

/// Gives the keyboard to the next pane of the canvas; after the last one to the bar across the top,
/// then to the column at the right, then to the canvas again. `by`: 1, or -1 for the way back.
void goToNextPart(MainWindow& window, int by)
{
    const app::Panes& panes = window.canvas().panes();
    const QList<Dock*> docks = column(window);
    const int count = int(panes.size()), bar = count, side = count + 1;
    const QWidget* focus = QApplication::focusWidget();
    const auto has = [focus](const QWidget* part) { return part->isAncestorOf(focus); };
    int now = has(&window.optionBar())          ? bar
              : std::ranges::any_of(docks, has) ? side
                                                : int(panes.active());
    for (int tries = 0; tries < count + 2; ++tries) {
        now = (now + by + count + 2) % (count + 2);
        QWidget* stop = now == bar                        ? firstStop(window.optionBar())
                        : now == side && !docks.isEmpty() ? firstStop(*docks.front())
                                                          : nullptr;
        if (now < count) {
            window.canvas().activatePane(std::size_t(now));
            return window.canvas().setFocus();
        }
        if (stop)
            return stop->setFocus(by > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    }
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
