// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/cut_options.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/exactness_panel.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/properties/properties_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_layout.h"
#include "ui/window/start.h"

// Creates the panels and connects their signals to the window.

namespace ui {

void MainWindow::addPanels()
{
    panelLayout_ = std::make_unique<PanelLayout>(*this, panels_.docks);
    connectPanels();
    connectLayout();
}

void MainWindow::connectPanels()
{
    connectStart(*panels_.start, *panelLayout_, *this);
    const auto focusCanvas = [this] { canvas_->setFocus(); };
    const auto showSize = [this] {
        panels_.window->showSize(canvas_->capsuleHome() == app::CapsuleHome::Off);
    };
    connect(canvas_, &Canvas::capsuleSwitched, this, showSize);
    showSize();
    connect(panels_.window, &WindowPanel::entered, canvas_, focusCanvas);
    connect(panels_.difference, &DifferencePanel::entered, canvas_, focusCanvas);
    connect(panels_.costMap, &CostMapPanel::entered, canvas_, focusCanvas);
    connect(panels_.exactness, &ExactnessPanel::entered, canvas_, focusCanvas);
    connect(panels_.window, &WindowPanel::refused, strip_, &MessageStrip::refuse);
    connect(panels_.window, &WindowPanel::taken, strip_, &MessageStrip::withdrawRefusal);
    connect(panels_.cutEdges, &CutOptionsBox::entered, canvas_, focusCanvas);
    connect(panels_.cutEdges, &CutOptionsBox::refused, strip_, &MessageStrip::refuse);
    connect(panels_.cutEdges, &CutOptionsBox::taken, strip_, &MessageStrip::withdrawRefusal);
    connect(canvas_, &Canvas::refused, strip_, &MessageStrip::refuse);
    connect(canvas_, &Canvas::taken, strip_, &MessageStrip::withdrawRefusal);
    connect(panels_.properties, &PropertiesPanel::entered, canvas_, focusCanvas);
    connect(panels_.properties, &PropertiesPanel::refused, strip_, &MessageStrip::refuse);
    connect(panels_.properties, &PropertiesPanel::taken, strip_, &MessageStrip::withdrawRefusal);
    connect(panels_.history, &HistoryPanel::stepWanted, canvas_, &Canvas::goToStep,
            Qt::QueuedConnection); // the list is still changing its current row
    connect(panels_.history, &HistoryPanel::clicked, canvas_, focusCanvas);
    connect(panels_.costMap, &CostMapPanel::told, this, &MainWindow::tell);
    const auto look = [this](const clipping::Window& place) {
        canvas_->go(app::lookingAt(canvas_->view(), place, session_.window()));
    };
    connect(panels_.difference, &DifferencePanel::placeWanted, this, look);
    connect(panels_.exactness, &ExactnessPanel::placeWanted, this, look);
    connect(panels_.line, &LinePanel::microscopeWanted, this, [this] {
        if (const auto line = session_.inspected())
            drawnLine_.look(*line);
    });
    connect(panels_.line, &LinePanel::lessonsWanted, this, &MainWindow::showLessons);
    connect(panels_.difference, &DifferencePanel::lineWanted, this,
            [this](std::size_t line) { drawnLine_.look(line); });
    connect(panels_.algorithm, &AlgorithmPanel::aboutWanted, this, &MainWindow::explanationWanted);
}

void MainWindow::connectLayout()
{
    connect(panelLayout_.get(), &PanelLayout::changed, this, &MainWindow::refreshActions);
    connect(panelLayout_.get(), &PanelLayout::aboutToRaise, &session_.microscope,
            &app::Microscope::close);
    connect(panelLayout_.get(), &PanelLayout::aboutToRaise, &sheets_, &app::LiveSheets::close);
    connect(panelLayout_.get(), &PanelLayout::aboutToRaise, this, &MainWindow::closeSheet);
    connect(panelLayout_.get(), &PanelLayout::aboutToRaise, canvas_, &Canvas::keepCorner);
    connect(panelLayout_.get(), &PanelLayout::aboutToBringBack, panels_.line, &LinePanel::showNow);
}

} // namespace ui
