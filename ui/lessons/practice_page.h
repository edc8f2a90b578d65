// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/practice.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

namespace ui {

class LookLabel;
class MoveInput;
class PageDots;

/// *Do it yourself* beside the microscope: the current move and where it is answered, or at the end
/// the result and where the student went wrong. Enter checks what is set, and goes on once the move
/// is settled. The best attempt at each variant is kept in the settings.
class PracticePage : public QWidget {
    Q_OBJECT

public:
    explicit PracticePage(app::Practice& practice, QWidget* parent = nullptr);

    void showAttempt(); ///< the attempt as it is now
    void focusNext();   ///< on the button or field with which keys go on

signals:
    void listWanted(); ///< of the lessons

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QLayout* makeHead();
    QWidget* makeBody();
    QLayout* makeFoot();
    void showMove();
    void showEnd();
    QWidget* nextInHand() const;

    app::Practice& practice_;
    QLabel *place_, *title_, *ending_, *wrongHead_, *count_;
    QScrollArea* body_;
    QWidget *box_, *wrong_;
    QLabel* prompt_;
    LookLabel* verdict_;
    MoveInput* input_;
    PageDots* dots_;
    QPushButton *check_, *giveUp_, *next_, *again_;
};

} // namespace ui
