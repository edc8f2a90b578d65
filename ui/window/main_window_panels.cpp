// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/seal.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/dock.h"
#include "ui/docks/exactness_panel.h"
#include "ui/docks/layers_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/start_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/files/files.h"
#include "ui/look/window_place.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QScopedValueRollback>
#include <QSettings>
#include <QTabBar>

#include <algorithm>

// The panels at the right and their arrangement. A layout that the person made is not changed.

namespace ui {

namespace {

const QString placeKey = QStringLiteral("geometry");
constexpr QSize usual(1280, 800);
constexpr int wide = 1200, high = 780; // below these sizes: narrow panels; tabs instead of a stack
constexpr int panelWidth = 336, narrowPanelWidth = 272, startWidth = 396, widePanelWidth = 572;
constexpr int separator = 4;   // between two panels
constexpr int barsHeight = 90; // menus, option bar and status bar, before they are laid out

} // namespace

void MainWindow::addPanels()
{
    auto* start = new StartPanel;
    algorithmPanel_ = new AlgorithmPanel(session_);
    auto* window = new WindowPanel(session_);
    auto* line = new LinePanel(session_);
    auto* layers = new LayersPanel(session_);
    docks_ = {new Dock("start", tr("Start"), start),
              new Dock("algorithm", tr("Algorithm"), algorithmPanel_),
              new Dock("window", tr("Clip window"), window), new Dock("line", tr("Line"), line),
              new Dock("layers", tr("Layers"), layers)};
    addWide();
    for (Dock* dock : docks_ + wide_)
        place(*dock);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setDockOptions(AllowTabbedDocks | AllowNestedDocks); // no animation
    connect(line, &LinePanel::titled, docks_[3],
            [this](const QString& title, const QString& remark) {
                docks_[3]->setRemark(remark);
                docks_[3]->setName(title);
            });
    connect(algorithmPanel_, &AlgorithmPanel::aboutWanted, this, &MainWindow::explanationWanted);
    const auto focusCanvas = [this] { canvas_->setFocus(); };
    connect(window, &WindowPanel::entered, canvas_, focusCanvas);
    connect(differencePanel_, &DifferencePanel::entered, canvas_, focusCanvas);
    connect(costMapPanel_, &CostMapPanel::entered, canvas_, focusCanvas);
    connect(exactnessPanel_, &ExactnessPanel::entered, canvas_, focusCanvas);
    connect(window, &WindowPanel::refused, strip_, &MessageStrip::refuse);
    connect(window, &WindowPanel::taken, strip_, &MessageStrip::withdrawRefusal);
    connect(window, &WindowPanel::resized, this, &MainWindow::fitStack, Qt::QueuedConnection);
    connectStart(*start);
    connect(line, &LinePanel::titled, this, &MainWindow::makeRoomForLine); // its size is known now
}

void MainWindow::place(Dock& dock)
{
    dock.setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    dock.setMinimumWidth(narrowPanelWidth);
    addDockWidget(Qt::RightDockWidgetArea, &dock);
    const auto moved = [this] {
        if (!arranging_ && isVisible())
            ownLayout_ = true;
    };
    connect(&dock, &QDockWidget::topLevelChanged, this, moved);
    connect(&dock, &QDockWidget::dockLocationChanged, this, moved);
    connect(&dock, &QDockWidget::visibilityChanged, this, &MainWindow::refreshDockTitles,
            Qt::QueuedConnection);
}

void MainWindow::connectStart(StartPanel& start)
{
    connect(&start, &StartPanel::drawWanted, this, [this] {
        files_->startNew();
        canvas_->setTool("line");
    });
    connect(&start, &StartPanel::openWanted, this, [this] { files_->open(); });
    connect(&start, &StartPanel::fileWanted, this,
            [this](const QString& path) { files_->open(path); });
    connect(&start, &StartPanel::lessonWanted, this, [this] {
        showLessons();
        session_.course.begin(0);
    });
    connect(&start, &StartPanel::paperWanted, this, &MainWindow::experimentWanted);
    connect(&start, &StartPanel::sampleWanted, files_.get(), &Files::openSample);
    const auto follow = [this, &start] { start.showRecent(files_->recent()); };
    connect(files_.get(), &Files::recentChanged, &start, follow);
    connect(files_.get(), &Files::nameChanged, &start,
            [this, &start] { start.markSample(files_->sample()); });
    follow();
    // Loading a drawing or changing it leaves Start and shows the working panels.
    connect(&session_, &app::Session::loaded, this, &MainWindow::leaveStart);
    connect(&session_.history, &app::History::indexChanged, this, [this](int index) {
        if (index > 0)
            leaveStart();
    });
}

/// Gives the line panel the room it needs when the first line is inspected.
void MainWindow::makeRoomForLine()
{
    const bool inspecting = session_.inspected().has_value();
    if (!layoutBefore_.isEmpty())
        return;
    if (inspecting && !inspecting_ && !ownLayout_ && arrangement_ == Arrangement::Stacked) {
        if (lowerTabs() != lowerTabs_)
            arrange();
        else {
            const QScopedValueRollback quiet(arranging_, true);
            shareHeight();
        }
        if (lowerTabs_ > 0)
            docks_[3]->raise();
    }
    inspecting_ = inspecting;
}

/// How many panels, counted from below, must share a place so that none is smaller than its
/// content.
int MainWindow::lowerTabs() const
{
    const auto needed = [](const Dock* dock) {
        return dock->widget()->minimumSizeHint().height() + space::dockTitleHeight + separator;
    };
    const int room = isVisible() ? centralWidget()->height() : height() - barsHeight;
    int above = 0;
    for (qsizetype i = 1; i < docks_.size(); ++i)
        above += needed(docks_[i]);
    if (above <= room)
        return 0;
    int below = needed(docks_.back());
    above -= below;
    for (int tabs = 2; tabs < docks_.size() - 1; ++tabs) {
        const int next = needed(docks_[docks_.size() - tabs]);
        above -= next;
        below = std::max(below, next);
        if (above + below <= room || tabs + 2 == docks_.size())
            return tabs;
    }
    return 0;
}

/// Rearranges if a panel has grown and leaves too little room for the others.
void MainWindow::fitStack()
{
    if (layoutBefore_.isEmpty() && !ownLayout_ && arrangement_ == Arrangement::Stacked
        && lowerTabs() != lowerTabs_)
        arrange();
}

QList<QAction*> MainWindow::panelToggles() const
{
    QList<QAction*> toggles;
    for (Dock* dock : docks_ + wide_)
        if (dock != docks_[0]) // Help > Start; it is shown and hidden automatically
            toggles << dock->toggleViewAction();
    return toggles;
}

void MainWindow::raisePanel(const QString& key)
{
    session_.microscope.close();
    if (key == QStringLiteral("start") && !ownLayout_) {
        starting_ = true;
        return arrange();
    }
    for (Dock* dock : docks_)
        if (dock->objectName() == key) {
            const QScopedValueRollback quiet(arranging_, true);
            if (dockWidgetArea(dock) == Qt::NoDockWidgetArea) {
                addDockWidget(Qt::RightDockWidgetArea, dock);
                tabifyDockWidget(docks_[1], dock);
            }
            dock->show();
            dock->raise();
        }
}

void MainWindow::leaveStart()
{
    if (!starting_)
        return;
    starting_ = false;
    arrange();
    if (arrangement_ == Arrangement::Tabs)
        raisePanel(QStringLiteral("algorithm"));
}

MainWindow::Arrangement MainWindow::fittingArrangement() const
{
    return starting_                                 ? Arrangement::StartInFront
           : height() < high || !openWide_.isEmpty() ? Arrangement::Tabs
                                                     : Arrangement::Stacked;
}

void MainWindow::arrange()
{
    if (!layoutBefore_.isEmpty())
        return; // the microscope hides all panels
    if (!ownLayout_)
        arrangeAs(fittingArrangement());
    else if (starting_)
        raisePanel(QStringLiteral("start"));
}

void MainWindow::arrangeAs(Arrangement arrangement)
{
    const QScopedValueRollback quiet(arranging_, true);
    arrangement_ = arrangement;
    lowerTabs_ = arrangement == Arrangement::Stacked ? lowerTabs() : 0;
    for (Dock* dock : docks_ + wide_) {
        dock->setFloating(false);
        removeDockWidget(dock);
    }
    const bool tabs = arrangement != Arrangement::Stacked;
    const bool start = arrangement == Arrangement::StartInFront;
    // No line is selected yet, or Start is finished.
    Dock* const hidden = start ? docks_[3] : docks_[0];
    Dock* last = nullptr;
    for (Dock* dock : openWide_ + docks_) {
        if (dock == hidden && !tabs)
            continue; // not even behind another panel, whose title would then be in a tab
        if (dock == docks_[2] && !openWide_.isEmpty())
            last = nullptr; // the panels from here on are below
        addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->setVisible(dock != hidden);
        const bool lower = docks_.indexOf(dock) > docks_.size() - lowerTabs_; // except the first
        if ((tabs || lower) && last)
            tabifyDockWidget(last, dock);
        last = dock;
    }
    docks_[2]->raise();
    (start ? docks_[0] : openWide_.isEmpty() ? docks_[1] : openWide_.last())->raise();
    resizeDocks({docks_[1]}, {columnWidth()}, Qt::Horizontal);
    if (!tabs)
        shareHeight();
    else if (!openWide_.isEmpty())
        shareHeightWithWide();
    refreshDockTitles();
}

int MainWindow::columnWidth() const
{
    if (!openWide_.isEmpty())
        return std::clamp(width() * 9 / 20, narrowPanelWidth, widePanelWidth);
    return width() < wide ? narrowPanelWidth : starting_ ? startWidth : panelWidth;
}

/// The algorithm and clip window panels get the height they need; line and layers share the rest.
void MainWindow::shareHeight()
{
    const auto needed = [](const Dock* dock) {
        return dock->widget()->sizeHint().height() + space::dockTitleHeight;
    };
    const int algorithm = needed(docks_[1]), window = needed(docks_[2]);
    if (lowerTabs_ > 0) {
        Dock* const lower = docks_[docks_.size() - lowerTabs_];
        const int above = lower == docks_[2] ? algorithm : algorithm + window;
        const int rest = std::max(160, height() - barsHeight - above);
        return lower == docks_[2] ? resizeDocks({docks_[1], lower}, {algorithm, rest}, Qt::Vertical)
                                  : resizeDocks({docks_[1], docks_[2], lower},
                                                {algorithm, window, rest}, Qt::Vertical);
    }
    const int rest = std::max(160, height() - 120 - algorithm - window);
    const int line = session_.inspected() ? rest * 11 / 20 : 90;
    resizeDocks({docks_[1], docks_[2], docks_[3], docks_[4]},
                {algorithm, window, line, rest - line}, Qt::Vertical);
}

/// In a tab group the tab is the title. Qt creates and deletes the tab bars together with the
/// docks.
void MainWindow::refreshDockTitles()
{
    if (!layoutBefore_.isEmpty())
        return;
    for (Dock* dock : docks_ + wide_) {
        const auto others = tabifiedDockWidgets(dock);
        const bool tab = !dock->isFloating() && std::ranges::any_of(others, [](auto* other) {
            return !other->isHidden();
        });
        dock->setTitle(tab ? Dock::Title::InTab : Dock::Title::Shown);
    }
    for (QTabBar* bar : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        bar->setFont(captionFont(font()));
        bar->setExpanding(false);
        bar->setDrawBase(false);
        bar->setElideMode(Qt::ElideNone);
    }
}

void MainWindow::resetLayout()
{
    ownLayout_ = false;
    arrange();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    const auto fitting = fittingArrangement();
    const bool tabsChange = fitting == Arrangement::Stacked && lowerTabs() != lowerTabs_;
    if (!ownLayout_ && (fitting != arrangement_ || tabsChange))
        arrange();
}

void MainWindow::saveLayout()
{
    QSettings settings;
    rememberPlace(*this, placeKey);
    settings.setValue("ownLayout", ownLayout_);
    if (ownLayout_)
        settings.setValue("layout", app::sealed(layoutBefore_.isEmpty() ? saveState(layoutVersion)
                                                                        : layoutBefore_));
}

void MainWindow::restoreLayout()
{
    const QScopedValueRollback quiet(arranging_, true);
    const QSettings settings;
    restorePlace(*this, placeKey, usual, minimumSize());
    const auto layout = app::unsealed(settings.value("layout").toByteArray());
    ownLayout_ =
        settings.value("ownLayout").toBool() && layout && restoreState(*layout, layoutVersion);
    for (Dock* dock : wide_)
        follow(*dock);
    arrange();
}

} // namespace ui
