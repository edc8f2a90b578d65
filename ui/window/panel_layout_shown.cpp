// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_layout.h"

#include <QAction>
#include <QMainWindow>

#include <algorithm>
#include <utility>

// Which panels are shown. Arrangement says where.

namespace ui {

namespace {

bool isInFront(const Dock& dock)
{
    return !dock.isHidden() && !dock.isBehind() && !dock.isFolded();
}

} // namespace

QList<QAction*> PanelLayout::toggles() const
{
    QList<QAction*> toggles;
    for (const Dock* dock : docks_.narrow + docks_.wide)
        toggles << dock->toggleViewAction();
    return toggles;
}

void PanelLayout::raise(const QString& key)
{
    emit aboutToRaise();
    if (key == docks_.start->objectName() && !own_.exists())
        return showStart();
    if (hidden())
        return defer([this, key] { raise(key); });
    for (Dock* dock : docks_.narrow + QList<Dock*>{docks_.start})
        if (dock->objectName() == key)
            bringToFront(*dock);
    for (Dock* dock : docks_.wide)
        if (dock->objectName() == key && !isInFront(*dock))
            setOpen(*dock, true);
}

void PanelLayout::bringToFront(Dock& narrow)
{
    if (narrow.isFolded())
        fold(narrow, false);
    const auto quiet = own_.byProgram();
    if (window_.dockWidgetArea(&narrow) == Qt::NoDockWidgetArea) {
        window_.addDockWidget(Qt::RightDockWidgetArea, &narrow);
        if (Dock* below = lowestDocked())
            window_.tabifyDockWidget(below, &narrow);
    }
    narrow.show();
    narrow.raise();
}

/// The last whole panel of the workspace that is in the column: a further panel shares its place.
Dock* PanelLayout::lowestDocked() const
{
    const QList<Dock*> column = docks_.named(workspace_->column);
    const auto docked = std::find_if(column.rbegin(), column.rend(), [this](const Dock* dock) {
        return !dock->isHidden() && !dock->isFloating() && !dock->isFolded()
               && window_.dockWidgetArea(const_cast<Dock*>(dock)) != Qt::NoDockWidgetArea;
    });
    return docked == column.rend() ? nullptr : *docked;
}

void PanelLayout::toggle(const QString& key)
{
    emit aboutToRaise();
    if (hidden())
        return defer([this, key] { toggle(key); });
    for (Dock* dock : docks_.wide)
        if (dock->objectName() == key)
            setOpen(*dock, !isInFront(*dock));
}

void PanelLayout::setOpen(Dock& wide, bool open)
{
    starting_ = starting_ && !open;
    if (wide.isFoldable()) // a section of this workspace
        fold(wide, !open);
    if (open || !wide.isFoldable()) {
        const auto quiet = own_.byProgram();
        if (open && window_.dockWidgetArea(&wide) == Qt::NoDockWidgetArea)
            window_.addDockWidget(Qt::RightDockWidgetArea, &wide);
        wide.setVisible(open);
        if (open)
            wide.raise();
    }
    for (Dock* dock : docks_.wide)
        follow(*dock);
}

/// The others make room for a comparison panel that was opened, and come back when it is closed.
void PanelLayout::follow(Dock& wide)
{
    if (hidden())
        return; // it is restored with the others
    const bool open = !wide.isHidden();
    if (open == openWide_.contains(&wide))
        return;
    open ? openWide_.append(&wide) : void(openWide_.removeAll(&wide));
    if (!own_.exists() && !own_.isByProgram())
        arrange();
    emit changed();
}

bool PanelLayout::shows(const QString& key) const
{
    return std::ranges::any_of(docks_.all(), [&key](const Dock* dock) {
        return dock->objectName() == key && !dock->isHidden();
    });
}

void PanelLayout::showStart()
{
    starting_ = true;
    arrange();
}

void PanelLayout::leaveStart()
{
    if (std::exchange(starting_, false))
        arrange();
}

} // namespace ui
