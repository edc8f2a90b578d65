// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_layout.h"

#include "app/base/text.h"
#include "ui/window/dock_tabs.h"

#include <QAction>
#include <QLayout>
#include <QMainWindow>
#include <QSettings>

#include <utility>

namespace ui {

namespace {

// In the settings.
const QString workspaceKey = QStringLiteral("workspace");

QString foldsKey(const Workspace& workspace) // which panels it folds
{
    return QStringLiteral("folds/") + app::latin(workspace.key);
}

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
    connect(&dock, &Dock::foldWanted, this, [this, &dock](bool folded) { fold(dock, folded); });
    // A panel that is not of the workspace has no place to be shown at.
    connect(dock.toggleViewAction(), &QAction::triggered, this, [this, &dock](bool shown) {
        if (shown && docks_.narrow.contains(&dock))
            bringToFront(dock);
    });
}

Situation PanelLayout::situation() const { return {workspace_, starting_, openWide_}; }

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
    showFolds();
    arrangement_.place(situation());
    showTitles();
}

void PanelLayout::fit()
{
    const bool fits = window_.isVisible() && arrangement_.fits(situation());
    if (!hidden() && !own_.exists() && !fits)
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
        own_.choose(app::latin(workspace.key));
        if (own_.exists())
            showFolds();
        else
            showWide();
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

/// Opens the comparison panels of the workspace, and closes the others.
void PanelLayout::showWide()
{
    for (Dock* dock : docks_.wide)
        dock->setVisible(workspace_->column.contains(dock->objectName()));
}

QStringList PanelLayout::folded() const
{
    return QSettings().value(foldsKey(*workspace_), workspace_->folds).toStringList();
}

/// What the settings name is folded only if it folds. Beside Start all panels are tabs. A
/// comparison panel that is the workspace's subject does not fold.
void PanelLayout::showFolds()
{
    const QStringList folded = this->folded();
    yielding_.clear();
    for (Dock* dock : docks_.all()) {
        const QString key = dock->objectName();
        const bool isNarrow = docks_.narrow.contains(dock) && workspace_->column.contains(key);
        dock->setFoldable(isNarrow || workspace_->folds.contains(key));
        dock->setFolded(!starting_ && dock->isFoldable() && folded.contains(key));
    }
}

/// Folds others, the lowest first, until the panel that was unfolded fits.
void PanelLayout::makeRoom(const Dock& opened)
{
    QList<Dock*> others = arrangement_.unfolded();
    while (arrangement_.needsTabs() && !others.isEmpty()) {
        Dock* const lowest = others.takeLast();
        if (lowest == &opened || !lowest->isFoldable())
            continue;
        lowest->setFolded(true);
        yielding_ << lowest;
    }
}

/// Unfolds what had made room, if there is room now.
void PanelLayout::takeBackRoom()
{
    for (Dock* const dock : std::exchange(yielding_, {})) {
        dock->setFolded(false);
        if (!arrangement_.needsTabs())
            continue;
        dock->setFolded(true);
        yielding_ << dock;
    }
}

void PanelLayout::saveFolds()
{
    QStringList folded;
    for (const Dock* dock : docks_.all())
        if (dock->isFoldable() && dock->isFolded())
            folded << dock->objectName();
    QSettings().setValue(foldsKey(*workspace_), folded);
}

void PanelLayout::fold(Dock& dock, bool folded)
{
    if (folded && arrangement_.unfolded() == QList{&dock})
        return; // one stays open
    const bool focused = dock.hasFocusInHeading();
    const auto quiet = own_.byProgram();
    window_.layout()->setEnabled(false); // the window would grow at once
    dock.setFolded(folded);
    yielding_.removeAll(&dock);
    if (!hidden() && !own_.exists() && !starting_)
        folded ? takeBackRoom() : makeRoom(dock);
    saveFolds();
    const bool fits = arrangement_.fits(situation());
    window_.layout()->setEnabled(true);
    if (hidden() || own_.exists())
        return;
    if (fits)
        arrangement_.shareHeight();
    else
        arrange(); // which takes the focus
    if (focused)
        dock.focusHeading();
}

void PanelLayout::reset()
{
    if (hidden())
        return defer([this] { reset(); });
    own_.forget();
    QSettings().remove(foldsKey(*workspace_));
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
    fit(); // the window's size has changed, or Start is finished
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
    own_.restore(app::latin(workspace_->key));
    if (own_.exists())
        showFolds();
    else
        showWide();
    for (Dock* dock : docks_.wide)
        follow(*dock);
    arrange();
    emit workspaceChanged();
}

} // namespace ui

#include "moc_panel_layout.cpp"
