// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_layout.h"

#include "ui/window/dock_tabs.h"

#include <QMainWindow>

#include <utility>

namespace ui {

PanelLayout::PanelLayout(QMainWindow& window, const PanelDocks& docks,
                         std::function<bool()> inspecting)
    : window_(window), docks_(docks), inspecting_(std::move(inspecting)), own_(window),
      arrangement_(window, docks), hiding_(window, docks.all())
{
    for (Dock* wide : docks_.wide) {
        wide->hide();
        connect(
            wide, &QDockWidget::visibilityChanged, this, [this, wide] { follow(*wide); },
            Qt::QueuedConnection);
    }
    for (Dock* dock : docks_.all())
        add(*dock);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    window.setDockOptions(QMainWindow::AllowTabbedDocks
                          | QMainWindow::AllowNestedDocks); // no animation
}

void PanelLayout::add(Dock& dock)
{
    dock.setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    dock.setMinimumWidth(Arrangement::narrowest);
    window_.addDockWidget(Qt::RightDockWidgetArea, &dock);
    own_.watch(dock);
    connect(&dock, &QDockWidget::visibilityChanged, this, &PanelLayout::showTitles,
            Qt::QueuedConnection);
}

Situation PanelLayout::situation() const { return {starting_, inspecting_(), openWide_}; }

void PanelLayout::arrange()
{
    if (hidden())
        return;
    if (own_.exists()) {
        if (starting_)
            raise(docks_.start->objectName());
        return;
    }
    const auto quiet = own_.byProgram();
    arrangement_.place(situation());
    showTitles();
}

void PanelLayout::makeRoomForLine()
{
    if (hidden())
        return;
    const bool hadLine = std::exchange(hadLine_, inspecting_());
    if (hadLine || !hadLine_ || own_.exists() || arrangement_.form() != Arrangement::Form::Stacked)
        return;
    if (!arrangement_.tabsFit()) {
        arrange();
    } else {
        const auto quiet = own_.byProgram();
        arrangement_.shareHeight(situation());
    }
    if (arrangement_.hasTabsBelow())
        docks_.line->raise();
}

void PanelLayout::fit()
{
    if (!hidden() && !own_.exists() && arrangement_.form() == Arrangement::Form::Stacked
        && !arrangement_.tabsFit())
        arrange();
}

void PanelLayout::fitWindow()
{
    const auto fitting = arrangement_.fitting(situation());
    const bool tabsChange = fitting == Arrangement::Form::Stacked && !arrangement_.tabsFit();
    if (!own_.exists() && (fitting != arrangement_.form() || tabsChange))
        arrange();
}

void PanelLayout::reset()
{
    if (hidden())
        return defer([this] { reset(); });
    own_.forget();
    arrange();
}

void PanelLayout::hideAll()
{
    if (hidden())
        return;
    before_ = own_.state();
    const auto quiet = own_.byProgram();
    hiding_.hide();
}

void PanelLayout::bringBack()
{
    if (!hidden())
        return;
    emit aboutToBringBack();
    {
        const auto quiet = own_.byProgram();
        hiding_.bringBack();
    }
    before_.clear();
    if (arrangement_.fitting(situation()) != arrangement_.form())
        arrange();     // the window's size has changed, or Start is finished
    makeRoomForLine(); // a line may have been inspected meanwhile
    fit();
    for (const auto& action : std::exchange(deferred_, {}))
        action();
    showTitles();
}

void PanelLayout::showTitles()
{
    if (!hidden())
        refreshTitles(window_, docks_.all());
}

void PanelLayout::save() const { own_.save(hidden() ? before_ : own_.state()); }

void PanelLayout::restore()
{
    const auto quiet = own_.byProgram();
    own_.restore();
    if (!starting_)
        docks_.start->hide(); // restoreState() shows docks that its data do not name
    for (Dock* dock : docks_.wide)
        follow(*dock);
    arrange();
}

} // namespace ui
