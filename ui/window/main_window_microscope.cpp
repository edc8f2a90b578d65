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

void MainWindow::addMicroscope()
{
    connect(&session_.microscope, &app::Microscope::openChanged, this,
            &MainWindow::followMicroscope);
    connect(&session_, &app::Session::loaded, &session_.microscope, &app::Microscope::close);
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
    if (bare_)
        return;
    bare_ = true;
    panelLayout_->hideAll();
    for (auto* bar : findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (!bar->isHidden())
            barsBefore_ << bar;
}

void MainWindow::endBare()
{
    bare_ = false;
    panelLayout_->bringBack();
    barsBefore_.clear();
}

} // namespace ui
