// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/status_bar.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/microscope/microscope_page.h"
#include "ui/widgets/window_note.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLayout>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolBar>

#include <cstdlib>
#include <utility>

// The microscope replaces the canvas and hides all panels. They are restored as they were.

namespace ui {

namespace {

/// The height of the tab bar above a panel, in logical pixels; 0: none.
int tabsAbove(const QDockWidget& dock, const QMainWindow& window)
{
    constexpr int nearby = 8; // pixels
    for (const auto* tabs : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        const QRect place = tabs->geometry();
        if (tabs->isVisible() && std::abs(place.bottom() - dock.y()) <= nearby
            && place.left() <= dock.geometry().right() && place.right() >= dock.x())
            return dock.y() - place.top();
    }
    return 0;
}

} // namespace

void MainWindow::addMicroscope()
{
    connect(&session_.microscope, &app::Microscope::openChanged, this,
            &MainWindow::followMicroscope);
    connect(&session_, &app::Session::loaded, &session_.microscope, &app::Microscope::close);
    connect(findChild<LinePanel*>(), &LinePanel::microscopeWanted, this, [this] {
        if (const auto line = session_.inspected())
            drawnLine_.look(*line);
    });
    connect(differencePanel_, &DifferencePanel::lineWanted, this,
            [this](std::size_t line) { drawnLine_.look(line); });
}

void MainWindow::followMicroscope()
{
    const bool open = session_.microscope.isOpen();
    if (open) {
        canvas_->endGesture();
        if (!microscopePage_)
            makeMicroscopePage();
        focusBefore_ = QApplication::focusWidget();
    } else {
        closeLessons();
    }
    fitMode();
    if (!open)
        (focusBefore_ && focusBefore_->isVisible() ? focusBefore_.data() : canvas_)->setFocus();
    refreshActions();
}

void MainWindow::makeMicroscopePage()
{
    microscopePage_ = new MicroscopePage(session_, drawnLine_);
    centre_->addWidget(microscopePage_);
    connect(microscopePage_, &MicroscopePage::closeWanted, &session_.microscope,
            &app::Microscope::close);
    connect(microscopePage_, &MicroscopePage::refused, this, [this](const QString& sentence) {
        tell({Message::Kind::Warning, sentence});
    });
    connect(microscopePage_, &MicroscopePage::pointerMoved, status_, &StatusBar::showPoint);
    connect(microscopePage_, &MicroscopePage::hinted, status_, &StatusBar::showHint);
    connect(microscopePage_, &MicroscopePage::aboutWanted, this,
            [this](const clipping::Algorithm* algorithm) { emit explanationWanted(*algorithm); });
    connect(microscopePage_, &MicroscopePage::exportWanted, this, &MainWindow::stepsExportWanted);
}

/// The microscope has its own bar and keeps the tool bar visible; presenting keeps the option bar
/// visible.
void MainWindow::fitMode()
{
    const bool microscope = session_.microscope.isOpen();
    if (microscope || isPresenting())
        makeBare();
    for (QToolBar* bar : barsBefore_)
        bar->setVisible(bar->orientation() == Qt::Horizontal ? !microscope : !isPresenting());
    showInCentre();
    if (!microscope && !isPresenting())
        endBare();
}

/// A stacked widget is at least as large as its largest page, hidden ones included, so hidden pages
/// are made to ask for no room.
void MainWindow::showInCentre()
{
    if (!microscopePage_)
        return;
    const bool microscope = session_.microscope.isOpen();
    const auto policy = microscope ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    microscopePage_->setSizePolicy(policy, policy);
    if (note_)
        note_->setVisible(!microscope);
    centre_->setCurrentWidget(microscope ? static_cast<QWidget*>(microscopePage_) : canvas_);
    for (QLayout* around : {centre_->layout(), centralWidget()->layout(), layout()}) {
        around->invalidate();
        around->activate();
    }
}

void MainWindow::makeBare()
{
    if (!layoutBefore_.isEmpty())
        return;
    layoutBefore_ = saveState(layoutVersion);
    const QScopedValueRollback quiet(arranging_, true);
    for (auto* dock : findChildren<QDockWidget*>()) {
        dock->toggleViewAction()->setEnabled(false);
        if (!dock->isHidden())
            hiddenDocks_.push_back({dock, dock->size() + QSize(0, tabsAbove(*dock, *this)),
                                    dock->x() >= 0 || dock->isFloating()});
    }
    for (const HiddenDock& hidden : hiddenDocks_)
        hidden.dock->hide();
    for (auto* bar : findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (!bar->isHidden())
            barsBefore_ << bar;
}

void MainWindow::endBare()
{
    if (layoutBefore_.isEmpty())
        return;
    findChild<LinePanel*>()->showNow(); // or it would have the height for another line
    bringPanelsBack();
    layoutBefore_.clear();
    barsBefore_.clear();
    if (fittingArrangement() != arrangement_) // the window's size has changed, or Start is finished
        arrange();
    makeRoomForLine(); // a line may have been inspected meanwhile
    fitStack();
    refreshDockTitles();
}

/// Does not use restoreState(), which would also show panels that are not placed in the window.
void MainWindow::bringPanelsBack()
{
    const QScopedValueRollback quiet(arranging_, true);
    for (auto* dock : findChildren<QDockWidget*>())
        dock->toggleViewAction()->setEnabled(true);
    QList<QDockWidget*> docked;
    QList<int> widths, heights;
    for (const HiddenDock& hidden : std::exchange(hiddenDocks_, {})) {
        hidden.dock->show();
        if (hidden.dock->isFloating())
            continue;
        if (hidden.inFront) {
            hidden.dock->raise();
            docked << hidden.dock;
            widths << hidden.size.width();
            heights << hidden.size.height();
        }
    }
    resizeDocks(docked, widths, Qt::Horizontal);
    resizeDocks(docked, heights, Qt::Vertical);
}

} // namespace ui
