// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

/// A question with a button for each answer. A first wrong answer brings a hint and a second try.
/// Once the question is settled it is said which answer is right, and why.
class ChoiceList : public QWidget {
    Q_OBJECT

public:
    explicit ChoiceList(QWidget* parent = nullptr);

    /// The question of the page that is read; a page without one hides it.
    void show(const app::Course& course);
    /// Of the choices, in their order.
    QList<QPushButton*> buttons() const { return buttons_; }
    /// The first that can still be chosen; null: none can.
    QPushButton* firstOpen() const;

signals:
    void chosen(int choice);
    void answerWanted(); ///< the reader gives up

private:
    void addButton(const QString& text);
    void mark(int button, bool right);
    QString verdict(const app::Course& course) const;

    QVBoxLayout* column_;
    QLabel *prompt_, *verdict_;
    QPushButton* giveUp_;
    QList<QPushButton*> buttons_;
};

} // namespace ui
