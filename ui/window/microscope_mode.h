// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/lessons/lesson_files.h"
#include "app/session/drawn_line.h"

#include <QPointer>
#include <QWidget>

namespace ui {

class Canvas;
class Centre;
class LessonPanel;
class MicroscopePage;

/// The microscope in place of the canvas, and the lessons beside it. Its page is made when it is
/// first entered.
class MicroscopeMode : public QObject {
    Q_OBJECT

public:
    MicroscopeMode(app::Session& session, app::DrawnLine& drawn, Canvas& canvas, Centre& centre);

    void enter(); ///< ends the canvas's gesture, and remembers what has the focus
    void leave(); ///< ends the lessons
    /// Gives the focus back to what had it on entering, or else to the canvas.
    void returnFocus();
    /// Replaces the page, because widgets take the sizes of type and marks when they are made.
    void remake();

    /// Shows the lessons; opens the microscope for them.
    void showLessons();
    bool showsLessons() const;
    /// Reads lesson files and folders of them on another thread, and shows them in the list.
    void openLessons(const QStringList& paths);

signals:
    void made(ui::MicroscopePage* page);
    void lessonsToggled();
    void lessonExportWanted();

private:
    void make();
    void closeLessons();
    LessonPanel* lessonPanel() const; ///< null: the lessons are not shown
    void openPlaces();

    app::Session& session_;
    app::DrawnLine& drawn_;
    Canvas& canvas_;
    Centre& centre_;
    QPointer<QWidget> focusBefore_;
    app::Background<std::vector<app::LessonFile>> reading_, readingPlaces_;
    bool openedPlaces_ = false; ///< the lessons of earlier runs
};

} // namespace ui
