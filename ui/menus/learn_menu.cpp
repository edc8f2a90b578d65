// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/menus/other_windows.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace ui {

namespace {

void toggleMicroscope(MainWindow& window)
{
    app::Session& session = window.session();
    if (session.microscope.isOpen())
        session.microscope.close();
    else
        window.drawnLine().look();
}

/// Inspects the next or previous line; begins with the first or last one.
void inspectNext(MainWindow& window, std::ptrdiff_t by)
{
    app::Session& session = window.session();
    if (session.microscope.isOpen())
        return window.drawnLine().go(by);
    const auto count = std::ptrdiff_t(session.scene.lines().size());
    const auto now = session.inspected() ? std::ptrdiff_t(*session.inspected())
                     : by > 0            ? -1
                                         : count;
    const auto line = std::size_t((now + by + count) % count);
    session.inspect(line);
    window.canvas().go(app::bringing(window.canvas().view(), session.scene.lines()[line]));
    window.raisePanel("line");
}

void toggleOverlay(MainWindow& window)
{
    window.session().changeDisplay(
        [](app::Display& display) { display.overlay = !display.overlay; });
}

QString lessonsFolder()
{
    return QSettings().value(QStringLiteral("lessonsFolder"), QDir::homePath()).toString();
}

/// Opens lessons that the person chose; remembers where.
void openLessons(MainWindow& window, const QStringList& paths)
{
    if (paths.isEmpty())
        return;
    QSettings().setValue(QStringLiteral("lessonsFolder"), QFileInfo(paths.front()).absolutePath());
    window.openLessons(paths);
}

void openLessonFolder(MainWindow& window)
{
    const QString folder = window.files().questions().lessonFolderToOpen(lessonsFolder());
    openLessons(window, folder.isEmpty() ? QStringList() : QStringList(folder));
}

void openLessonFiles(MainWindow& window)
{
    openLessons(window, window.files().questions().lessonsToOpen(lessonsFolder()));
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo learnMenu()
{
    return {
        .title = Text::tr("&Learn"),
        .rows =
            {
                {
                    .key = "lessons",
                    .text = Text::tr("&Lessons"),
                    .keys = {QKeySequence("Ctrl+F1")},
                    .icon = "book",
                    .run = [](MainWindow& w) { w.showLessons(); },
                    .checked = [](const MainWindow& w) { return w.showsLessons(); },
                },
                {
                    .key = "open-lessons",
                    .text = Text::tr("&Open folder of lessons…"),
                    .icon = "folder",
                    .run = openLessonFolder,
                },
                {
                    .key = "open-lesson-files",
                    .text = Text::tr("Open lesson files…"),
                    .run = openLessonFiles,
                    .paletteOnly = true,
                },
                {
                    .key = "export-lesson",
                    .text = Text::tr("Export lesson as &web page…"),
                    .icon = "export",
                    .show = &OtherWindows::exportLesson,
                    .enabled = [](const MainWindow& w) { return w.session().course.lesson(); },
                    .paletteOnly = true, // it is a button of the lesson
                },
                {
                    .key = "microscope",
                    .text = Text::tr("Clip &microscope"),
                    .keys = {QKeySequence("F2")},
                    .icon = "microscope",
                    .run = toggleMicroscope,
                    .checked = [](const MainWindow& w) { return w.session().microscope.isOpen(); },
                },
                {
                    .key = "next-line",
                    .text = Text::tr("Inspect &next line"),
                    .keys = {QKeySequence("F8")},
                    .run = [](MainWindow& w) { inspectNext(w, 1); },
                    .enabled = someLines,
                    .submenu = Text::tr("Inspect a l&ine"),
                },
                {
                    .key = "previous-line",
                    .text = Text::tr("Inspect p&revious line"),
                    .keys = {QKeySequence("Shift+F8")},
                    .run = [](MainWindow& w) { inspectNext(w, -1); },
                    .enabled = someLines,
                    .submenu = Text::tr("Inspect a l&ine"),
                },
                {},
                {
                    .key = "overlay",
                    .text = Text::tr("What the algorithm &sees"),
                    .keys = {QKeySequence("F3"), QKeySequence("Ctrl+R")},
                    .icon = "regions",
                    .run = toggleOverlay,
                    .checked = [](const MainWindow& w) { return w.session().display().overlay; },
                },
                {
                    .key = "cost-map",
                    .text = Text::tr("&Cost map"),
                    .keys = {QKeySequence("Shift+F2")},
                    .run = [](MainWindow& w) { w.togglePanel("cost-map"); },
                    .checked = [](const MainWindow& w) { return w.showsPanel("cost-map"); },
                },
                {
                    .key = "exactness",
                    .text = Text::tr("E&xactness"),
                    .keys = {QKeySequence("Shift+F3")},
                    .run = [](MainWindow& w) { w.togglePanel("exactness"); },
                    .checked = [](const MainWindow& w) { return w.showsPanel("exactness"); },
                },
                {},
                {
                    .key = "about-algorithm",
                    .text = Text::tr("About this &algorithm"),
                    .keys = {QKeySequence("Shift+F1")},
                    .icon = "book",
                    .show = &OtherWindows::explainCurrent,
                },
                {
                    .key = "export-steps",
                    .text = Text::tr("Export s&teps…"),
                    .icon = "export",
                    .show = &OtherWindows::exportSteps,
                    .enabled = [](const MainWindow& w) { return w.session().microscope.isOpen(); },
                },
            },
    };
}

} // namespace ui
