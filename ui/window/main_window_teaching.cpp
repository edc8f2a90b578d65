// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_panel.h"
#include "ui/microscope/microscope_page.h"
#include "ui/window/main_window.h"

#include <QApplication>

// Functions for teaching: lessons beside the microscope, and presenting on a projector.

namespace ui {

namespace {

constexpr double larger = 1.5; // factor of the font size while presenting

QFont enlarged(QFont font)
{
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * larger));
    else
        font.setPointSizeF(font.pointSizeF() * larger);
    return font;
}

/// Existing widgets adopt a new font only with a new style sheet.
void setFontOfAll(const QFont& font)
{
    QApplication::setFont(font);
    qApp->setStyleSheet(qApp->styleSheet());
}

} // namespace

void MainWindow::showLessons()
{
    if (!session_.microscope.isOpen())
        drawnLine_.look();
    if (!microscopePage_->side()) {
        auto* lessons = new LessonPanel(session_.course);
        // Queued: the panel is deleted, but not while it handles an event.
        connect(lessons, &LessonPanel::closeWanted, this, &MainWindow::closeLessons,
                Qt::QueuedConnection);
        microscopePage_->setSide(lessons);
    }
    microscopePage_->side()->setFocus();
    refreshActions();
}

bool MainWindow::showsLessons() const { return microscopePage_ && microscopePage_->side(); }

void MainWindow::closeLessons()
{
    session_.course.end();
    if (microscopePage_)
        microscopePage_->setSide(nullptr);
    refreshActions();
}

/// Widgets take the sizes of type and marks when they are created, so the microscope's page is
/// recreated.
void MainWindow::togglePresenting()
{
    app::Display display = session_.display();
    display.presenting = !display.presenting;
    if (display.presenting) {
        fontBefore_ = QApplication::font();
        statesBefore_ = windowState();
        setFontOfAll(enlarged(*fontBefore_));
        setWindowState(windowState() | Qt::WindowFullScreen);
    } else {
        setFontOfAll(*std::exchange(fontBefore_, std::nullopt));
        setWindowState(statesBefore_);
    }
    session_.setDisplay(display);
    remakeMicroscopePage();
    fitMode();
    refreshActions();
}

void MainWindow::remakeMicroscopePage()
{
    if (!microscopePage_)
        return;
    const bool lessons = showsLessons();
    std::exchange(microscopePage_, nullptr)->deleteLater();
    makeMicroscopePage();
    if (!session_.microscope.isOpen())
        return;
    centre_->setCurrentWidget(microscopePage_);
    if (lessons)
        showLessons();
}

} // namespace ui
