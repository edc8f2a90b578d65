// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/choice_list.h"

#include "ui/look.h"
#include "ui/look_icon.h"

#include <QAccessible>

namespace ui {

namespace {

/// A label that wraps and can be read aloud.
QLabel* sentence()
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

ChoiceList::ChoiceList(QWidget* parent)
    : QWidget(parent), column_(new QVBoxLayout(this)), prompt_(sentence()), verdict_(sentence())
{
    column_->setContentsMargins(0, space::labelToField, 0, 0);
    column_->setSpacing(space::labelToField - 2);
    prompt_->setFont(semiBold(font()));
    column_->addWidget(prompt_);
    column_->addWidget(verdict_);
}

void ChoiceList::ask(const std::optional<app::Question>& question, std::optional<int> answer)
{
    setVisible(question.has_value());
    for (QPushButton* button : buttons_) {
        button->hide();
        button->deleteLater(); // it may be the one that was pressed
    }
    buttons_.clear();
    if (!question)
        return;
    prompt_->setText(question->prompt);
    for (const QString& choice : question->choices)
        addButton(choice);
    verdict_->setVisible(answer.has_value());
    if (!answer)
        return;
    const bool right = *answer == question->right;
    verdict_->setText((right ? tr("Right. ") : tr("Not quite. ")) + question->reason);
    mark(question->right, true);
    if (!right)
        mark(*answer, false);
    QAccessibleEvent told(verdict_, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&told);
}

void ChoiceList::addButton(const QString& text)
{
    auto* button = new QPushButton(text);
    const int index = int(buttons_.size());
    button->setMinimumHeight(space::toolButton);
    button->setAutoDefault(true); // Enter presses it
    connect(button, &QPushButton::clicked, this, [this, index] { emit chosen(index); });
    column_->insertWidget(column_->count() - 1, button);
    button->show(); // now, so that it can have the focus
    buttons_ << button;
}

/// What was chosen, and what is right, by a sign and by words; no other can be chosen any more.
void ChoiceList::mark(int button, bool right)
{
    for (QPushButton* other : buttons_)
        other->setEnabled(false);
    const Look& look = lookOf(palette());
    QPushButton& marked = *buttons_[button];
    marked.setEnabled(true);
    marked.setIcon(icon(right ? "tick" : "close"));
    marked.setAccessibleDescription(right ? tr("right") : tr("chosen, and wrong"));
    QPalette colours = marked.palette();
    colours.setColor(QPalette::ButtonText, right ? look.good : look.differs);
    marked.setPalette(colours);
}

} // namespace ui
