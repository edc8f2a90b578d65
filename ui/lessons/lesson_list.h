// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"

#include <QScrollArea>

namespace app {
class Practice;
struct LessonGroup;
struct Variant;
} // namespace app

class QAbstractButton;
class QBoxLayout;

namespace ui {

class PracticeEntry;

/// All lessons, each with a sentence and its best score; passed lessons have a tick. The lesson in
/// progress says at which page it goes on. Below those of the program are *Do it yourself* and the
/// opened ones, each folder under its heading.
class LessonList : public QScrollArea {
    Q_OBJECT

public:
    LessonList(const app::Course& course, const app::Practice& practice, QWidget* parent = nullptr);

    QList<QAbstractButton*> buttons() const { return buttons_; }
    QAbstractButton* buttonOf(std::size_t lesson) const; ///< of its number; or the first
    void refresh(); ///< updates scores, ticks, font, and which lessons there are
    /// On this lesson; otherwise on the one in progress, otherwise on the first.
    void focusOnLesson(std::optional<std::size_t> lesson = {});

signals:
    void chosen(int lesson);
    void closeWanted();
    void practiceChosen(const app::Variant& variant);
    void practiceGoesOn();

private:
    void addLesson(QBoxLayout& column, std::size_t lesson);
    void addOpened();
    QWidget* headingOf(const app::LessonGroup& group);

    const app::Course& course_;
    QList<QAbstractButton*> buttons_;
    std::vector<std::size_t> numbers_; ///< of the buttons' lessons
    QWidget* opened_;                  ///< the lessons that people opened
    int openings_ = 0;                 ///< that it shows
    PracticeEntry* practice_;
};

} // namespace ui
