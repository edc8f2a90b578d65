// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/next_part.h"

#include "ui/bars/option_bar.h"
#include "ui/docks/dock.h"
#include "ui/window/main_window.h"

#include <QApplication>

#include <algorithm>

namespace ui {

namespace {

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

} // namespace

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

} // namespace ui
