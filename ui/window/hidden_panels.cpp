// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/hidden_panels.h"

#include "ui/docks/dock.h"
#include "ui/window/dock_tabs.h"

#include <QAction>
#include <QMainWindow>

#include <utility>

namespace ui {

HiddenPanels::HiddenPanels(QMainWindow& window, QList<Dock*> docks)
    : window_(window), docks_(std::move(docks))
{
}

void HiddenPanels::hide()
{
    for (Dock* dock : docks_) {
        dock->toggleViewAction()->setEnabled(false);
        if (!dock->isHidden())
            places_.push_back(
                {dock, dock->size() + QSize(0, heightOfTabs(window_, *dock)), !dock->isBehind()});
    }
    for (const Place& place : places_)
        place.dock->hide();
}

/// Does not use restoreState(), which would also show panels that are not placed in the window.
void HiddenPanels::bringBack()
{
    for (Dock* dock : docks_)
        dock->toggleViewAction()->setEnabled(true);
    QList<QDockWidget*> docked;
    QList<int> widths, heights;
    for (const Place& place : std::exchange(places_, {})) {
        place.dock->show();
        if (place.dock->isFloating() || !place.inFront)
            continue;
        place.dock->raise();
        docked << place.dock;
        widths << place.size.width();
        heights << place.size.height();
    }
    window_.resizeDocks(docked, widths, Qt::Horizontal);
    window_.resizeDocks(docked, heights, Qt::Vertical);
}

} // namespace ui
