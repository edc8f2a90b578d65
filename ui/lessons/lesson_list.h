// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"

#include <QScrollArea>

class QAbstractButton;

namespace ui {

/// All lessons, each with a sentence and its best score; passed lessons have a tick. The lesson in
/// progress says at which page it goes on.
class LessonList : public QScrollArea {
    Q_OBJECT

public:
    explicit LessonList(const app::Course& course, QWidget* parent = nullptr);

    QList<QAbstractButton*> buttons() const { return buttons_; }
    void refresh(); ///< updates scores, ticks and font
    void focusOnLesson(); ///< on the one in progress, otherwise on the first

signals:
    void chosen(int lesson);
    void closeWanted();

private:
    const app::Course& course_;
    QList<QAbstractButton*> buttons_;
};

} // namespace ui
