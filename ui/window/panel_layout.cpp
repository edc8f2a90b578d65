// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_layout.h"

#include "app/base/text.h"
#include "ui/window/dock_tabs.h"

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include <utility>

namespace ui {

namespace {

const QString workspaceKey = QStringLiteral("workspace"); // in the settings

} // namespace

PanelLayout::PanelLayout(QMainWindow& window, const PanelDocks& docks)
    : window_(window), docks_(docks), own_(window), arrangement_(window, docks),
      hiding_(window, docks.all()), workspace_(&findWorkspace({}))
{
    for (Dock* wide : docks_.wide) {
        wide->hide();
        connect(
            wide, &QDockWidget::visibilityChanged, this, [this, wide] { follow(*wide); },
            Qt::QueuedConnection);
    }
    for (Dock* dock : docks_.all())
        add(*dock);
    docks_.algorithm->setFoldable(true);
    connect(docks_.algorithm, &Dock::foldWanted, this, &PanelLayout::fold);
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
    // A panel that is not of the workspace has no place to be shown at.
    connect(dock.toggleViewAction(), &QAction::triggered, this, [this, &dock](bool shown) {
        if (shown && docks_.working().contains(&dock))
            bringToFront(dock);
    });
}

Situation PanelLayout::situation() const { return {workspace_, starting_, folded_, openWide_}; }

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

void PanelLayout::choose(const Workspace& workspace)
{
    if (hidden())
        return defer([this, &workspace] { choose(workspace); });
    if (workspace_ == &workspace && !starting_)
        return;
    emit aboutToRaise();
    starting_ = false;
    {
        const auto quiet = own_.byProgram();
        workspace_ = &workspace;
        folded_ = workspace.folds;
        own_.choose(app::latin(workspace.key));
        if (own_.exists()) {
            docks_.algorithm->setFolded(folded_);
        } else {
            showWide();
        }
        for (Dock* dock : docks_.wide)
            follow(*dock);
    }
    arrange();
    showTitles();
    // At once: the program may be killed, and go on with a recovered drawing.
    QSettings().setValue(workspaceKey, app::latin(workspace_->key));
    emit workspaceChanged();
    emit changed();
}

/// Opens the comparison panel of the workspace, and closes the others.
void PanelLayout::showWide()
{
    for (Dock* dock : docks_.wide)
        dock->setVisible(dock->objectName() == workspace_->wide);
}

void PanelLayout::fold(bool folded)
{
    folded_ = folded;
    if (own_.exists())
        docks_.algorithm->setFolded(folded);
    else
        arrange();
}

void PanelLayout::reset()
{
    if (hidden())
        return defer([this] { reset(); });
    own_.forget();
    folded_ = workspace_->folds;
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
        arrange(); // the window's size has changed, or Start is finished
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

void PanelLayout::save()
{
    own_.save(hidden() ? before_ : own_.state());
    QSettings().setValue(workspaceKey, app::latin(workspace_->key));
}

void PanelLayout::restore()
{
    const auto quiet = own_.byProgram();
    workspace_ = &findWorkspace(QSettings().value(workspaceKey).toString().toStdString());
    folded_ = workspace_->folds;
    own_.restore(app::latin(workspace_->key));
    if (own_.exists())
        docks_.algorithm->setFolded(folded_);
    else
        showWide();
    for (Dock* dock : docks_.wide)
        follow(*dock);
    arrange();
    emit workspaceChanged();
}

} // namespace ui

#include "moc_panel_layout.cpp"
