// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dock_tabs.h"

#include "ui/docks/dock.h"
#include "ui/look/look.h"

#include <QMainWindow>
#include <QTabBar>

#include <algorithm>

namespace ui {

namespace {

QList<QTabBar*> tabBars(const QMainWindow& window)
{
    return window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly);
}

bool sharesItsPlace(const QMainWindow& window, Dock& dock)
{
    const auto others = window.tabifiedDockWidgets(&dock);
    return !dock.isFloating()
           && std::ranges::any_of(others, [](const auto* other) { return !other->isHidden(); });
}

/// A tab's text is the title of its dock.
bool hasTabOf(const QTabBar& bar, const Dock& dock)
{
    for (int tab = 0; tab < bar.count(); ++tab)
        if (bar.tabText(tab) == dock.windowTitle())
            return true;
    return false;
}

} // namespace

void refreshTitles(QMainWindow& window, const QList<Dock*>& docks)
{
    for (Dock* dock : docks)
        dock->setTitle(sharesItsPlace(window, *dock) ? Dock::Title::InTab : Dock::Title::Shown);
    for (QTabBar* bar : tabBars(window)) {
        bar->setFont(captionFont(window.font()));
        bar->setExpanding(false);
        bar->setDrawBase(false);
        bar->setElideMode(Qt::ElideNone);
        // Qt keeps bars of places that are gone, without tabs, above others, whose clicks they get.
        bar->setFocusPolicy(bar->count() == 0 ? Qt::NoFocus : Qt::TabFocus);
        if (bar->count() == 0)
            bar->lower();
    }
}

int heightOfTabs(const QMainWindow& window, const Dock& dock)
{
    for (const QTabBar* bar : tabBars(window))
        if (bar->isVisible() && hasTabOf(*bar, dock))
            return bar->height();
    return 0;
}

} // namespace ui
