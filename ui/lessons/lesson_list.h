// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QAbstractButton;

namespace ui {

/// All lessons, each with a sentence and its best score; passed lessons have a tick.
class LessonList : public QScrollArea {
    Q_OBJECT

public:
    explicit LessonList(QWidget* parent = nullptr);

    QList<QAbstractButton*> buttons() const { return buttons_; }
    void refresh(); ///< updates scores, ticks and font

signals:
    void chosen(int lesson);
    void closeWanted();

private:
    QList<QAbstractButton*> buttons_;
};

} // namespace ui
