// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/practice_page.h"

#include "app/base/numbers.h"
#include "app/comparison/variants.h"
#include "app/practice/record.h"
#include "ui/lessons/choice_list.h"
#include "ui/lessons/move_input.h"
#include "ui/lessons/page_dots.h"
#include "ui/lessons/page_parts.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int insetOfBox = 16, marginOfPage = 48, narrowMarginOfPage = 20, wideEnough = 430;

/// A box framed in the selection colour.
class MoveBox : public QWidget {
protected:
    void paintEvent(QPaintEvent*) override
    {
        const Look& look = lookOf(palette());
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(look.selection);
        painter.setBrush(look.base);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), space::radius,
                                space::radius);
    }
};

QPushButton* pageButton(const QString& text, const QString& tip)
{
    auto* made = new QPushButton(text);
    made->setToolTip(tip);
    made->setMinimumHeight(space::toolButton);
    made->setMinimumWidth(made->sizeHint().width() + 2 * space::labelToField);
    made->setAutoDefault(true); // Enter presses it
    return made;
}

/// Points are not broken over two lines: "(−160, −30)".
QString withWholePoints(QString text)
{
    static const QRegularExpression comma(QStringLiteral("(?<=\\d)([,;]) (?=[\\d\u2212])"));
    return text.replace(comma, QStringLiteral("\\1\u00a0"));
}

void wrap(QLabel& label)
{
    label.setWordWrap(true);
    label.setTextFormat(Qt::PlainText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse);
}

} // namespace

PracticePage::PracticePage(app::Practice& practice, QWidget* parent)
    : QWidget(parent), practice_(practice), place_(new QLabel), title_(new QLabel),
      ending_(new QLabel), wrongHead_(new QLabel(Text::tr("Where did I go wrong?"))),
      count_(new QLabel), body_(new QScrollArea), box_(new MoveBox), wrong_(new QWidget),
      prompt_(new QLabel), verdict_(new LookLabel), input_(new MoveInput(practice)),
      dots_(new PageDots),
      check_(pageButton(Text::tr("Check"), Text::tr("Check the answer (Enter)"))),
      giveUp_(pageButton(Text::tr("Show the answer"),
                         Text::tr("Show the right answer and its reason. The move then does not "
                                  "count as right."))),
      next_(pageButton(Text::tr("Next"), Text::tr("Next move (Enter)"))),
      again_(pageButton(Text::tr("Another line"),
                        Text::tr("Begin again with another line; your best result is kept")))
{
    setObjectName(QStringLiteral("practice"));
    setAccessibleName(Text::tr("Do it yourself"));
    next_->setObjectName(QStringLiteral("next-move"));
    check_->setObjectName(QStringLiteral("check-move"));
    giveUp_->setObjectName(QStringLiteral("show-move"));
    giveUp_->setFlat(true);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(space::betweenGroups);
    column->addLayout(makeHead());
    column->addWidget(makeBody(), 1);
    column->addLayout(makeFoot());
    connect(check_, &QPushButton::clicked, input_, &MoveInput::check);
    connect(input_, &MoveInput::refused, verdict_, [this](const QString& sentence) {
        verdict_->setText(sentence);
        verdict_->setVisible(true);
    });
    connect(giveUp_, &QPushButton::clicked, &practice, &app::Practice::showAnswer);
    connect(next_, &QPushButton::clicked, &practice, &app::Practice::next);
    connect(again_, &QPushButton::clicked, this,
            [this] { practice_.begin(app::Variant(practice_.tracedLine().variant)); });
    showAttempt();
}

QLayout* PracticePage::makeHead()
{
    QToolButton* const all = linkToLessons();
    connect(all, &QToolButton::clicked, this, &PracticePage::listWanted);
    place_->setToolTip(Text::tr("Moves that were right at the first try, and how many of them "
                                "pass the attempt"));
    return pageHead(*place_, *all, *title_);
}

QWidget* PracticePage::makeBody()
{
    for (QLabel* label : {prompt_, static_cast<QLabel*>(verdict_), ending_})
        wrap(*label);
    wearFont(*prompt_, pageType::question, QFont::DemiBold);
    wearFont(*ending_, pageType::text, QFont::DemiBold);
    wearFont(*wrongHead_, pageType::question, QFont::DemiBold);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(check_);
    buttons->addWidget(giveUp_);
    buttons->addStretch();
    auto* inBox = new QVBoxLayout(box_);
    inBox->setContentsMargins(insetOfBox, insetOfBox, insetOfBox, insetOfBox);
    inBox->setSpacing(space::labelToField);
    inBox->addWidget(prompt_);
    inBox->addWidget(input_);
    inBox->addWidget(verdict_);
    inBox->addLayout(buttons);
    auto* wrong = new QVBoxLayout(wrong_);
    wrong->setContentsMargins(0, 0, 0, 0);
    wrong->setSpacing(space::labelToField);
    auto* inner = new QWidget;
    auto* column = new QVBoxLayout(inner);
    column->setContentsMargins(0, 0, 4, 0);
    column->setSpacing(space::betweenGroups);
    column->addWidget(box_);
    column->addWidget(ending_);
    column->addWidget(again_, 0, Qt::AlignLeft);
    column->addWidget(wrongHead_);
    column->addWidget(wrong_);
    column->addStretch();
    makePageBody(*body_, *inner);
    return body_;
}

QLayout* PracticePage::makeFoot() { return pageFoot(*dots_, *count_, {next_}); }

void PracticePage::showAttempt()
{
    if (!practice_.isOn())
        return;
    const bool end = practice_.atEnd();
    const std::size_t all = practice_.moves().size();
    place_->setText(Text::tr("Do it yourself · %1 of %2 right, %3 pass")
                        .arg(practice_.rightAtOnce())
                        .arg(all)
                        .arg(practice_.needed()));
    const app::Variant& variant = practice_.tracedLine().variant;
    title_->setText(variant.form == clipping::Form::Published
                        ? Text::tr("%1, as published").arg(app::latin(variant.algorithm->name))
                        : Text::tr("%1, corrected").arg(app::latin(variant.algorithm->name)));
    const std::size_t shown = std::min(practice_.index(), all - 1);
    dots_->show(shown, all);
    count_->setText(Text::tr("%1 of %2").arg(shown + 1).arg(all));
    box_->setVisible(!end);
    for (QWidget* atEnd : {static_cast<QWidget*>(ending_), static_cast<QWidget*>(again_)})
        atEnd->setVisible(end);
    end ? showEnd() : showMove();
    setFocusProxy(nextInHand());
}

void PracticePage::showMove()
{
    prompt_->setText(withWholePoints(practice_.move()->prompt));
    input_->showMove();
    const bool open = practice_.isOpen();
    const app::MoveAnswer& given = practice_.answerTo(practice_.index());
    verdict_->setText(practice_.verdict());
    verdict_->setVisible(!verdict_->text().isEmpty());
    verdict_->setColour([right = given.right, wrong = !given.tries.empty()](const Look& look) {
        return right ? look.good : wrong ? errorColour(look) : look.text;
    });
    check_->setVisible(open && input_->isChecked());
    giveUp_->setVisible(open);
    next_->setVisible(true);
    next_->setEnabled(!open);
    next_->setText(practice_.index() + 1 < practice_.moves().size() ? Text::tr("Next")
                                                                    : Text::tr("Finish"));
    wrongHead_->hide();
    wrong_->hide();
    QAccessibleEvent told(verdict_, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&told);
}

/// The result, and each move that was not right at the first try, with a button that shows its
/// step.
void PracticePage::showEnd()
{
    if (!ending_->text().isEmpty() && ending_->text() == practice_.ending() && wrong_->isVisible())
        return; // the microscope has only gone to another step
    ending_->setText(practice_.ending());
    next_->setVisible(false);
    QSettings settings;
    const auto all = double(practice_.moves().size());
    app::keepRecord(settings, practice_.tracedLine().variant,
                    {int(100 * practice_.rightAtOnce() / all), practice_.isPassed()});
    while (QLayoutItem* item = wrong_->layout()->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    const auto moves = practice_.wrongMoves();
    for (const std::size_t index : moves) {
        const app::Move& move = practice_.moves()[index];
        auto* look = pageButton(Text::tr("%1, step %2").arg(move.brief).arg(move.step + 1),
                                Text::tr("Show this step in the microscope"));
        connect(look, &QPushButton::clicked, this, [this, index] { practice_.lookAt(index); });
        auto* words = new QLabel(practice_.correction(index));
        wrap(*words);
        wrong_->layout()->addWidget(look);
        wrong_->layout()->addWidget(words);
        look->show();
        words->show();
    }
    wrongHead_->setVisible(!moves.empty());
    wrong_->setVisible(!moves.empty());
    body_->verticalScrollBar()->setValue(0);
}

QWidget* PracticePage::nextInHand() const
{
    if (practice_.atEnd())
        return again_;
    QWidget* first = practice_.isOpen() ? input_->first() : nullptr;
    return first ? first : next_;
}

void PracticePage::focusNext()
{
    if (practice_.isOn() && !practice_.isPaused())
        nextInHand()->setFocus();
}

/// Enter checks, also from a field or a bit.
void PracticePage::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && practice_.asks() && input_->isChecked())
        input_->check();
    else if (enter && !practice_.isOpen() && !practice_.atEnd())
        practice_.next();
    else
        QWidget::keyPressEvent(event);
}

void PracticePage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int side = width() < wideEnough ? narrowMarginOfPage : marginOfPage;
    layout()->setContentsMargins(side, side, side - 4, side / 2);
}

} // namespace ui

#include "moc_practice_page.cpp"
