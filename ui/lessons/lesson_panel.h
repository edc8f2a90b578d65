// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"

#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTextBrowser>
#include <QToolButton>

namespace ui {

class ChoiceList;
class LessonList;

/// The lessons beside the microscope: the list of them, or the page that is read, with its
/// question. The microscope shows what the page is about. Page Up and Page Down turn the pages; Up,
/// Down and Enter answer.
class LessonPanel : public QStackedWidget {
    Q_OBJECT

public:
    explicit LessonPanel(app::Course& course, QWidget* parent = nullptr);

    void showList();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void closeWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeReader();
    QLayout* makeHead();
    QLayout* makeFoot();
    void showPage();
    void showText();
    void turn(int pages);

    app::Course& course_;
    LessonList* list_;
    QLabel *title_, *place_;
    QTextBrowser* text_;
    ChoiceList* choices_;
    QToolButton *back_, *again_, *next_;
};

} // namespace ui
