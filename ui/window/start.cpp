// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start.h"

#include "ui/docks/start_panel.h"
#include "ui/files/files.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_layout.h"
#include "ui/window/workspaces.h"

namespace ui {

void connectStart(StartPanel& start, PanelLayout& layout, MainWindow& window)
{
    Files& files = window.files();
    QObject::connect(&start, &StartPanel::drawWanted, &window, [&window] {
        // First, since the new drawing may be in a window of its own, which takes them over.
        window.choose(findWorkspace("workspace-draw"));
        window.canvas().setTool("line");
        window.files().startNew();
    });
    // The button that was clicked goes: keys are for the drawing at once.
    const auto draw = [&window] {
        if (window.isVisible()) // not another drawing
            window.canvas().setFocus();
    };
    for (const auto wanted : {&StartPanel::drawWanted, &StartPanel::openWanted})
        QObject::connect(&start, wanted, &window, draw, Qt::QueuedConnection);
    QObject::connect(&start, &StartPanel::fileWanted, &window, draw, Qt::QueuedConnection);
    QObject::connect(&start, &StartPanel::sampleWanted, &window, draw, Qt::QueuedConnection);
    QObject::connect(&start, &StartPanel::openWanted, &files, qOverload<>(&Files::open));
    QObject::connect(&start, &StartPanel::fileWanted, &files,
                     qOverload<const QString&>(&Files::open));
    QObject::connect(&start, &StartPanel::sampleWanted, &files, &Files::openSample);
    QObject::connect(&start, &StartPanel::lessonWanted, &window, [&window] {
        window.showLessons();
        window.session().course.begin(0);
    });
    QObject::connect(&start, &StartPanel::paperWanted, &window, &MainWindow::experimentWanted);
    const auto follow = [&start, &files] { start.showRecent(files.recent()); };
    QObject::connect(&files, &Files::recentChanged, &start, follow);
    QObject::connect(&files, &Files::nameChanged, &start,
                     [&start, &files] { start.markSample(files.sample()); });
    follow();
    const app::Session& session = window.session();
    QObject::connect(&session, &app::Session::loaded, &window, [&layout] { layout.leaveStart(); });
    QObject::connect(&session.history, &app::History::indexChanged, &window, [&layout](int index) {
        if (index > 0)
            layout.leaveStart();
    });
}

} // namespace ui
