// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/choice_list.h"

#include "ui/lessons/page_parts.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"

#include <QAccessible>
#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int inset = 16;

/// A button whose text continues in further lines where it is narrow.
class ChoiceButton : public QPushButton {
public:
    explicit ChoiceButton(const QString& text) : QPushButton(text), whole_(text) {}
    QSize sizeHint() const override
    {
        constexpr int besideLines = 6; // pixels above and below several lines
        const QSize hint = QPushButton::sizeHint();
        return text().contains(u'\n') ? hint + QSize(0, 2 * besideLines) : hint;
    }
    QSize minimumSizeHint() const override { return {inset, sizeHint().height()}; }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QPushButton::resizeEvent(event);
        QStringList lines(QString{});
        for (const QString& word : whole_.split(u' ')) {
            const QString longer = lines.back().isEmpty() ? word : lines.back() + u' ' + word;
            const bool fits = fontMetrics().horizontalAdvance(longer) <= width() - 2 * inset;
            fits || lines.back().isEmpty() ? lines.back() = longer : lines.emplace_back(word);
        }
        if (const QString broken = lines.join(u'\n'); broken != text())
            setText(broken);
    }

private:
    QString whole_;
};

/// A label that wraps and that screen readers can read.
LookLabel* sentence()
{
    auto* label = new LookLabel;
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

ChoiceList::ChoiceList(QWidget* parent)
    : QWidget(parent), column_(new QVBoxLayout(this)), prompt_(sentence()), onStage_(sentence()),
      verdict_(sentence()), giveUp_(new QPushButton(Text::tr("Show the answer")))
{
    column_->setContentsMargins(inset, inset, inset, inset);
    column_->setSpacing(space::labelToField - 2);
    wearFont(*prompt_, pageType::question, QFont::DemiBold);
    onStage_->setText(Text::tr("You can also click it in the figure."));
    onStage_->setForegroundRole(QPalette::PlaceholderText);
    giveUp_->setObjectName(QStringLiteral("show-answer"));
    giveUp_->setFlat(true);
    giveUp_->setMinimumWidth(giveUp_->sizeHint().width() + 2 * space::labelToField);
    giveUp_->setAutoDefault(true); // Enter presses it
    giveUp_->setToolTip(Text::tr(
        "Show the right answer and its reason. The question then does not count as right."));
    connect(giveUp_, &QPushButton::clicked, this, &ChoiceList::answerWanted);
    column_->addWidget(prompt_);
    column_->addWidget(onStage_);
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
    open_ = course.isOpen();
    giveUp_->setVisible(open_);
    onStage_->setVisible(open_ && question && !question->parts.empty());
    prompt_->setText(question
                         ? question->prompt
                         : Text::tr("The question of this page cannot be asked about this line. "
                                    "Choose “Show example”, or drag an end elsewhere."));
    if (question)
        showChoices(*question, course);
    verdict_->setText(verdict(course));
    verdict_->setVisible(!verdict_->text().isEmpty());
    const app::Answer& answer = course.answer();
    verdict_->setColour([right = answer.right, wrong = answer.wrong > 0](const Look& look) {
        return right ? look.good : wrong ? errorColour(look) : look.text;
    });
    update();
    QAccessibleEvent told(verdict_, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&told);
}

/// A box, which is framed in the selection colour while the question is open.
void ChoiceList::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(open_ ? look.selection : look.border);
    painter.setBrush(look.base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), space::radius,
                            space::radius);
}

void ChoiceList::showChoices(const app::Question& question, const app::Course& course)
{
    for (const QString& choice : question.choices)
        addButton(choice);
    QWidget* before = giveUp_; // Tab goes from the first one on to this button
    for (QPushButton* button : buttons_) {
        setTabOrder(before, button);
        before = button;
    }
    setTabOrder(before, giveUp_);
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
    auto* button = new ChoiceButton(Text::tr("%1  %2", "the digit of an answer, the answer")
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

/// Marks a choice; marking the right one disables the others.
void ChoiceList::mark(int button, bool right)
{
    if (right)
        for (QPushButton* other : buttons_)
            other->setEnabled(false);
    buttons_[button]->setEnabled(right);
    markAnswer(*buttons_[button], right);
}

} // namespace ui

#include "moc_choice_list.cpp"
