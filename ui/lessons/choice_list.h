// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/question.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

/// A question with a button for each answer. The first that is pressed counts; then it is said
/// which one is right, and why.
class ChoiceList : public QWidget {
    Q_OBJECT

public:
    explicit ChoiceList(QWidget* parent = nullptr);

    /// Nothing hides it.
    void ask(const std::optional<app::Question>& question, std::optional<int> answer);
    QList<QPushButton*> buttons() const { return buttons_; }

signals:
    void chosen(int choice);

private:
    void addButton(const QString& text);
    void mark(int button, bool right);

    QVBoxLayout* column_;
    QLabel *prompt_, *verdict_;
    QList<QPushButton*> buttons_;
};

} // namespace ui
