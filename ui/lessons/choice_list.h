// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

/// The sizes of type on a lesson's page, as multiples of the program's (wearFont()).
namespace pageType {
constexpr double title = 2.0, question = 1.3, text = 1.23;
} // namespace pageType

class LookLabel;

/// A question with a button for each answer, which shows the digit that gives it. After a first
/// wrong answer it shows a hint and allows a second try. Once the question is settled it says which
/// answer is right, and why.
class ChoiceList : public QWidget {
    Q_OBJECT

public:
    explicit ChoiceList(QWidget* parent = nullptr);

    /// Shows the question of the current page; hides the widget if the page has none.
    void show(const app::Course& course);
    /// The choices' buttons, in order.
    QList<QPushButton*> buttons() const { return buttons_; }
    /// The first button that is still enabled; null: none.
    QPushButton* firstOpen() const;

signals:
    void chosen(int choice);
    void answerWanted(); ///< the reader gives up and asks for the answer

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void showChoices(const app::Question& question, const app::Course& course);
    void addButton(const QString& text);
    void mark(int button, bool right);
    QString verdict(const app::Course& course) const;

    QVBoxLayout* column_;
    QLabel *prompt_, *onStage_;
    LookLabel* verdict_;
    bool open_ = false;
    QPushButton* giveUp_;
    QList<QPushButton*> buttons_;
};

} // namespace ui
