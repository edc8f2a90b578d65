// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/choice_list.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAccessible>

#include <algorithm>

namespace ui {

namespace {

/// A label that wraps and that screen readers can read.
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
    : QWidget(parent), column_(new QVBoxLayout(this)), prompt_(sentence()), verdict_(sentence()),
      giveUp_(new QPushButton(Text::tr("Show the answer")))
{
    column_->setContentsMargins(0, space::labelToField, 0, 0);
    column_->setSpacing(space::labelToField - 2);
    prompt_->setFont(semiBold(font()));
    giveUp_->setObjectName(QStringLiteral("show-answer"));
    giveUp_->setFlat(true);
    giveUp_->setMinimumWidth(giveUp_->sizeHint().width() + 2 * space::labelToField);
    giveUp_->setAutoDefault(true); // Enter presses it
    giveUp_->setToolTip(Text::tr(
        "Show the right answer and its reason. You then get no points for this question."));
    connect(giveUp_, &QPushButton::clicked, this, &ChoiceList::answerWanted);
    column_->addWidget(prompt_);
    column_->addWidget(verdict_);
    column_->addWidget(giveUp_, 0, Qt::AlignLeft);
}

void ChoiceList::show(const app::Course& course)
{
    const auto& question = course.question();
    setVisible(question || course.isOpen());
    for (QPushButton* button : buttons_) {
        button->hide();
        button->deleteLater(); // Deleted later: it may be handling its click
    }
    buttons_.clear();
    giveUp_->setVisible(course.isOpen());
    prompt_->setText(question
                         ? question->prompt
                         : Text::tr("The question of this page cannot be asked about this line. "
                                    "Choose “Show example”, or drag an end elsewhere."));
    if (question)
        showChoices(*question, course);
    verdict_->setText(verdict(course));
    verdict_->setVisible(!verdict_->text().isEmpty());
    QAccessibleEvent told(verdict_, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&told);
}

void ChoiceList::showChoices(const app::Question& question, const app::Course& course)
{
    for (const QString& choice : question.choices)
        addButton(choice);
    for (const int choice : course.answer().tries)
        if (choice != question.right)
            mark(choice, false);
    if (!course.isOpen())
        mark(question.right, true);
}

/// The judgement of the last try, with a hint.
QString ChoiceList::verdict(const app::Course& course) const
{
    const app::Answer& answer = course.answer();
    if (!course.question())
        return {};
    const app::Question& question = *course.question();
    if (course.isOpen())
        return answer.wrong == 0
                   ? QString()
                   : Text::tr("Not quite. You have one more try. Hint: %1").arg(question.hint);
    if (answer.shown)
        return question.reason;
    return (answer.right ? Text::tr("Right. ") : Text::tr("Not quite. ")) + question.reason;
}

QPushButton* ChoiceList::firstOpen() const
{
    const auto open = std::ranges::find_if(
        buttons_, [](const QPushButton* b) { return b->isEnabled() && b->icon().isNull(); });
    return open == buttons_.end() ? nullptr : *open;
}

void ChoiceList::addButton(const QString& text)
{
    const int index = int(buttons_.size());
    auto* button = new QPushButton(Text::tr("%1  %2", "the digit of an answer, the answer")
                                       .arg(index + 1)
                                       .arg(QString(text).replace(u'&', QStringLiteral("&&"))));
    button->setAccessibleName(text);
    button->setToolTip(Text::tr("Press %1 to give this answer").arg(index + 1));
    button->setMinimumHeight(space::toolButton);
    button->setAutoDefault(true); // Enter presses it
    connect(button, &QPushButton::clicked, this, [this, index] { emit chosen(index); });
    column_->insertWidget(column_->count() - 2, button); // above the verdict
    button->show(); // shown at once, so that it can take the focus
    buttons_ << button;
}

/// Marks a choice that was tried or is right, with a sign and in words. Marking the right one
/// disables the others.
void ChoiceList::mark(int button, bool right)
{
    if (right)
        for (QPushButton* other : buttons_)
            other->setEnabled(false);
    const Look& look = lookOf(palette());
    QPushButton& marked = *buttons_[button];
    marked.setEnabled(right);
    marked.setIcon(icon(right ? "tick" : "close"));
    marked.setAccessibleDescription(right ? Text::tr("right") : Text::tr("chosen, and wrong"));
    QPalette colours = marked.palette();
    for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
        colours.setColor(group, QPalette::ButtonText, right ? look.good : look.differs);
    marked.setPalette(colours);
}

} // namespace ui

#include "moc_choice_list.cpp"
