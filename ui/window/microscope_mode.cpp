// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/microscope_mode.h"

#include "app/lessons/lesson_places.h"
#include "app/lessons/opened_lessons.h"
#include "ui/canvas/canvas.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/microscope/microscope_page.h"
#include "ui/window/centre.h"

#include <QApplication>
#include <QFileInfo>
#include <QSettings>

#include <utility>

namespace ui {

MicroscopeMode::MicroscopeMode(app::Session& session, app::DrawnLine& drawn, Canvas& canvas,
                               Centre& centre)
    : session_(session), drawn_(drawn), canvas_(canvas), centre_(centre)
{
}

void MicroscopeMode::enter()
{
    canvas_.endGesture();
    if (!centre_.microscope())
        make();
    focusBefore_ = QApplication::focusWidget();
}

void MicroscopeMode::leave() { closeLessons(); }

void MicroscopeMode::returnFocus()
{
    (focusBefore_ && focusBefore_->isVisible() ? focusBefore_.data() : &canvas_)->setFocus();
}

void MicroscopeMode::make()
{
    auto* page = new MicroscopePage(session_, drawn_);
    centre_.setMicroscope(page);
    connect(page, &MicroscopePage::closeWanted, &session_.microscope, &app::Microscope::close);
    emit made(page);
}

void MicroscopeMode::remake()
{
    if (!centre_.microscope())
        return;
    const bool lessons = showsLessons();
    make();
    if (!session_.microscope.isOpen())
        return;
    centre_.showMicroscope();
    if (lessons)
        showLessons();
}

void MicroscopeMode::showLessons()
{
    if (!session_.microscope.isOpen())
        drawn_.look();
    MicroscopePage& page = *centre_.microscope();
    if (!page.side()) {
        auto* lessons = new LessonPanel(session_.course, session_.practice);
        // Queued: the panel is deleted, but not while it handles an event.
        connect(lessons, &LessonPanel::closeWanted, this, &MicroscopeMode::closeLessons,
                Qt::QueuedConnection);
        connect(lessons, &LessonPanel::exportWanted, this, &MicroscopeMode::lessonExportWanted);
        page.setSide(lessons);
    }
    page.side()->setFocus();
    openPlaces();
    emit lessonsToggled();
}

bool MicroscopeMode::showsLessons() const
{
    return centre_.microscope() && centre_.microscope()->side();
}

LessonPanel* MicroscopeMode::lessonPanel() const
{
    return showsLessons() ? qobject_cast<LessonPanel*>(centre_.microscope()->side()) : nullptr;
}

/// Reads the lessons that were opened in earlier runs, unless another window has. What is gone is
/// not told of: it may be on a stick that is back tomorrow.
void MicroscopeMode::openPlaces()
{
    if (std::exchange(openedPlaces_, true))
        return;
    QStringList places = app::lessonPlaces(QSettings());
    places.removeIf([](const QString& path) { return app::isOpened(path); });
    if (places.isEmpty())
        return;
    const auto read = [places](const app::Follower& follower) {
        QStringList present = places;
        present.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
        return app::readLessonFiles(present, follower);
    };
    readingPlaces_.start(read, [this](std::vector<app::LessonFile> files) {
        app::addOpenedLessons(std::move(files));
        if (LessonPanel* panel = lessonPanel())
            panel->refreshList();
    });
}

void MicroscopeMode::openLessons(const QStringList& paths)
{
    if (paths.isEmpty())
        return;
    reading_.start(
        [paths](const app::Follower& follower) { return app::readLessonFiles(paths, follower); },
        [this, paths](std::vector<app::LessonFile> files) {
            const auto first = app::addOpenedLessons(std::move(files));
            QSettings settings;
            if (first)
                app::keepLessonPlaces(settings, paths);
            showLessons();
            if (LessonPanel* panel = lessonPanel())
                panel->showOpened(first);
        });
}

void MicroscopeMode::closeLessons()
{
    session_.course.end();
    session_.practice.end();
    if (centre_.microscope())
        centre_.microscope()->setSide(nullptr);
    emit lessonsToggled();
}

} // namespace ui

#include "moc_microscope_mode.cpp"
