// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/requests.h"

#include "ui/bars/option_bar.h"
#include "ui/experiment/experiment_window.h"
#include "ui/explanation/explanation_window.h"
#include "ui/window/commands.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QMenuBar>

#include <algorithm>

namespace ui {

void connectRequests(MainWindow& window)
{
    const QList<QAction*> all = commands(*window.menuBar());
    const auto command = [&all](const char* key) {
        return *std::ranges::find(all, QLatin1StringView(key), &QAction::objectName);
    };
    window.optionBar().addCommands(*command("undo"), *command("redo"), *command("export"));
    QObject::connect(&window, &MainWindow::stepsExportWanted, command("export-steps"),
                     &QAction::trigger);
    QObject::connect(&window, &MainWindow::experimentWanted, &window,
                     [&window] { showExperiment(window); });
    QObject::connect(
        &window, &MainWindow::explanationWanted, &window,
        [&window](const clipping::Algorithm& algorithm) { showExplanation(algorithm, window); });
}

} // namespace ui
