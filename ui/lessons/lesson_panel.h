// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"
#include "app/practice/practice.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>

namespace ui {

class ChoiceList;
class LessonList;
class PageDots;
class PagePicture;
class PracticePage;

/// The lessons beside the microscope: their list, the current page with its question, or *Do it
/// yourself*. The
/// microscope shows the page's example. Page Up and Page Down turn the pages; Up, Down and Enter
/// answer, or the digit of an answer (MicroscopePage). The last page says whether the lesson is
/// passed. The best score of each lesson is kept in the settings.
class LessonPanel : public QStackedWidget {
    Q_OBJECT

public:
    LessonPanel(app::Course& course, app::Practice& practice, QWidget* parent = nullptr);

    void showList();
    void refreshList(); ///< after lessons were opened
    /// The list with lessons that were opened just now, from this one on; empty: none could be.
    void showOpened(std::optional<std::size_t> lesson);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void closeWanted();
    void exportWanted(); ///< of the lesson

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeReader();
    QLayout* makeHead();
    QWidget* makeBody();
    QLayout* makeFoot();
    void showPage();
    void showPractice();
    void showHead();
    void showEnding();
    void showFoot();
    void turn(int pages);
    void focusNext();
    QWidget* nextInHand() const; ///< the button with which Enter continues or answers

    app::Course& course_;
    app::Practice& practice_;
    LessonList* list_;
    QWidget* reader_;
    PracticePage* practicePage_;
    QLabel *place_, *title_, *text_, *told_, *ending_, *count_;
    QScrollArea* body_;
    PagePicture* picture_;
    ChoiceList* choices_;
    PageDots* dots_;
    QPushButton *back_, *again_, *skip_, *next_, *repeat_;
};

} // namespace ui
