// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/looking.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/dock.h"
#include "ui/docks/exactness_panel.h"
#include "ui/look/look.h"
#include "ui/window/main_window.h"

#include <QScopedValueRollback>

#include <algorithm>

// The comparison panels. They need more width than the others, which then share the place below
// them. Closing them restores the previous layout.

namespace ui {

void MainWindow::addWide()
{
    auto* compare = new ComparePanel(session_);
    auto* dock = new Dock("compare", tr("Compare"), compare);
    differencePanel_ = new DifferencePanel(session_);
    costMapPanel_ = new CostMapPanel(session_);
    exactnessPanel_ = new ExactnessPanel(session_);
    wide_ = {dock, new Dock("difference", tr("Differences"), differencePanel_),
             new Dock("cost-map", tr("Cost map"), costMapPanel_),
             new Dock("exactness", tr("Exactness"), exactnessPanel_)};
    const auto look = [this](const clipping::Window& place) {
        canvas_->go(app::lookingAt(canvas_->view(), place, session_.window()));
    };
    connect(differencePanel_, &DifferencePanel::placeWanted, this, look);
    connect(exactnessPanel_, &ExactnessPanel::placeWanted, this, look);
    connect(dock, &QDockWidget::visibilityChanged, compare, &ComparePanel::setWatched);
    connect(costMapPanel_, &CostMapPanel::told, this, [this](const QString& sentence) {
        tell({Message::Kind::Done, sentence});
    });
    for (Dock* wide : wide_) {
        wide->hide();
        connect(
            wide, &QDockWidget::visibilityChanged, this, [this, wide] { follow(*wide); },
            Qt::QueuedConnection);
    }
}

void MainWindow::follow(Dock& wide)
{
    if (!layoutBefore_.isEmpty())
        return; // it is restored with the others
    const bool open = !wide.isHidden();
    if (open == openWide_.contains(&wide))
        return;
    open ? openWide_.append(&wide) : void(openWide_.removeAll(&wide));
    if (!ownLayout_ && !arranging_)
        arrange();
    refreshActions();
}

bool MainWindow::showsPanel(const QString& key) const
{
    const auto* dock = findChild<Dock*>(key);
    return dock && !dock->isHidden();
}

void MainWindow::togglePanel(const QString& key)
{
    session_.microscope.close();
    for (Dock* dock : wide_) {
        if (dock->objectName() != key)
            continue;
        // Qt moves docks behind other tabs off the screen.
        const bool behind = dock->x() < 0 && !dock->isFloating();
        const bool open = dock->isHidden() || behind;
        starting_ = starting_ && !open;
        const QScopedValueRollback quiet(arranging_, true);
        if (open && dockWidgetArea(dock) == Qt::NoDockWidgetArea)
            addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->setVisible(open);
        if (open)
            dock->raise();
    }
    for (Dock* dock : wide_)
        follow(*dock);
}

/// The front panel gets the height it needs, as long as some is left for those below.
void MainWindow::shareHeightWithWide()
{
    constexpr int leastBelow = 190;
    const int all = centralWidget()->height();
    Dock* front = openWide_.last();
    const int needed = front->widget()->sizeHint().height() + space::dockTitleHeight;
    const int above = std::min(needed, all - leastBelow);
    resizeDocks({front, docks_[2]}, {above, all - above}, Qt::Vertical);
}

} // namespace ui
