// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/move_input.h"

#include "app/base/expression.h"
#include "app/base/numbers.h"
#include "app/practice/plan.h"
#include "app/teaching/manual.h"
#include "ui/lessons/page_parts.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr int placesOfSlider = 1000;

/// A slider that takes the keys that move it, though they step through the microscope elsewhere.
class PlaceSlider : public QSlider {
public:
    PlaceSlider() : QSlider(Qt::Horizontal) {}

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::ShortcutOverride) {
            const int key = static_cast<QKeyEvent*>(event)->key();
            if ((key >= Qt::Key_Left && key <= Qt::Key_Down) || key == Qt::Key_Home
                || key == Qt::Key_End || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
                event->accept();
                return true;
            }
        }
        return QSlider::event(event);
    }
};

/// A number that what is typed replaces.
class LineNumber : public QSpinBox {
protected:
    void focusInEvent(QFocusEvent* event) override
    {
        QSpinBox::focusInEvent(event);
        selectAll();
    }
};

/// A number as it is typed, also "3/4"; the decimal mark is a point, or that of the locale.
app::Result<double> numberIn(QString text)
{
    text.replace(QChar(0x2212), u'-');
    text.replace(QLocale().decimalPoint(), QStringLiteral("."));
    return app::evaluated(text.trimmed().toStdString(), {});
}

} // namespace

MoveInput::MoveInput(app::Practice& practice, QWidget* parent)
    : QWidget(parent), practice_(practice), column_(new QVBoxLayout(this))
{
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(space::labelToField - 2);
    connect(&practice, &app::Practice::draftChanged, this, &MoveInput::showDraft);
}

void MoveInput::add(QWidget* widget)
{
    column_->addWidget(widget);
    widget->show(); // shown at once, so that it can take the focus
}

void MoveInput::showMove()
{
    const QString typed = value_ ? value_->text() : QString();
    const bool typedHere = value_ && practice_.asks() && value_->isEnabled()
                           && practice_.answerTo(practice_.index()).tries.size() == 1;
    while (QLayoutItem* item = column_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // Deleted later: it may be handling its event
        delete item;
    }
    buttons_.clear();
    slider_ = nullptr;
    line_ = nullptr;
    value_ = nullptr;
    const app::Move* move = practice_.move();
    if (!practice_.isOn() || !move)
        return;
    using Show = void (MoveInput::*)(const app::Move& move);
    static constexpr std::array<Show, 6> shows{&MoveInput::showBits,  &MoveInput::showEdges,
                                               &MoveInput::showPlace, &MoveInput::showLine,
                                               &MoveInput::showValue, &MoveInput::showDecisions};
    (this->*shows[std::size_t(move->kind)])(*move); // in the order of MoveKind
    if (typedHere && value_)
        value_->setText(typed);
    setEnabled(practice_.asks());
    if (const QString way = app::alsoIn(move->kind); practice_.asks() && !way.isEmpty()) {
        QLabel* also = quietLabel(way);
        also->setWordWrap(true);
        add(also);
    }
    showDraft();
}

/// A button for each bit, which shows it, with its question below.
void MoveInput::showBits(const app::Move& move)
{
    auto* bits = new QWidget;
    auto* row = new QHBoxLayout(bits);
    row->setContentsMargins(0, 0, 0, 0);
    for (int k = 0; k < move.bits.size(); ++k) {
        auto* button = new QPushButton;
        button->setCheckable(true);
        button->setMinimumSize(44, space::toolButton + 6);
        button->setToolTip(Text::tr("Press %1 to change this bit").arg(k + 1));
        connect(button, &QPushButton::clicked, this, [this, k] { practice_.useDigit(k + 1); });
        auto* name = new QLabel(move.bits[k]);
        name->setFont(captionFont(font()));
        name->setForegroundRole(QPalette::PlaceholderText);
        name->setAlignment(Qt::AlignHCenter);
        auto* column = new QVBoxLayout;
        column->setSpacing(2);
        column->addWidget(button);
        column->addWidget(name);
        row->addLayout(column);
        buttons_ << button;
    }
    row->addStretch();
    add(bits);
}

/// A button for each answer, which shows the digit that gives it; wrong tries are disabled.
void MoveInput::showChoices(const QStringList& choices, int firstAnswer)
{
    const app::Move& move = *practice_.move();
    const app::MoveAnswer& given = practice_.answerTo(practice_.index());
    for (int k = 0; k < choices.size(); ++k) {
        const int answer = firstAnswer + k;
        auto* button = new QPushButton(
            Text::tr("%1  %2", "the digit of an answer, the answer").arg(k + 1).arg(choices[k]));
        button->setAccessibleName(choices[k]);
        button->setToolTip(Text::tr("Press %1 to give this answer").arg(k + 1));
        button->setMinimumHeight(space::toolButton);
        button->setAutoDefault(true); // Enter presses it
        const bool wrong = std::ranges::count(given.tries, answer) > 0 && answer != move.right;
        const bool right = given.settled() && answer == move.right;
        if (wrong || right)
            markAnswer(*button, right);
        button->setEnabled(!wrong);
        connect(button, &QPushButton::clicked, this, [this, answer] { practice_.answer(answer); });
        buttons_ << button;
        add(button);
    }
}

void MoveInput::showEdges(const app::Move& move)
{
    QStringList names;
    for (const int edge : {1, 2, 3, 4}) // as clipping::Edge
        names << app::answerText(move, edge, practice_.tracedLine().y);
    showChoices(names, 1);
}

void MoveInput::showDecisions(const app::Move&)
{
    showChoices(
        {Text::tr("Accept the line"), Text::tr("Reject the line"), Text::tr("More to do first")},
        0);
}

void MoveInput::showPlace(const app::Move&)
{
    slider_ = new PlaceSlider;
    slider_->setRange(0, placesOfSlider);
    slider_->setSingleStep(5);
    slider_->setPageStep(50);
    slider_->setAccessibleName(Text::tr("Place of the cut, from End 1 to End 2"));
    slider_->setToolTip(Text::tr("Left and Right move the cut, Page Up and Page Down further"));
    connect(slider_, &QSlider::valueChanged, this,
            [this](int value) { practice_.setDraft(double(value) / placesOfSlider); });
    auto* names = new QWidget;
    auto* row = new QHBoxLayout(names);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(Text::tr("End 1")));
    row->addWidget(slider_, 1);
    row->addWidget(new QLabel(Text::tr("End 2")));
    add(names);
}

void MoveInput::showLine(const app::Move&)
{
    line_ = new LineNumber;
    line_->setRange(0, int(app::codeOf(practice_.tracedLine().variant).size()));
    line_->setSpecialValueText(Text::tr("none"));
    line_->setPrefix(Text::tr("line "));
    line_->setAccessibleName(Text::tr("Next line of the pseudo-code"));
    connect(line_, &QSpinBox::valueChanged, this, [this](int line) {
        if (line > 0)
            practice_.setDraft(line);
    });
    add(line_);
}

void MoveInput::showValue(const app::Move& move)
{
    value_ = new QLineEdit;
    value_->setPlaceholderText(Text::tr("a number, or a sum such as (70+100)/230"));
    value_->setAccessibleName(Text::tr("Value of %1").arg(move.name));
    add(value_);
}

/// Shows what is set, or once the move is settled, what is right.
void MoveInput::showDraft()
{
    const app::Move* move = practice_.move();
    if (!practice_.isOn() || !move)
        return;
    const bool settled = practice_.answerTo(practice_.index()).settled();
    const double now = settled ? move->right : practice_.draft().value_or(0);
    if (move->kind == app::MoveKind::Bits && buttons_.size() == move->bits.size())
        for (int k = 0; k < buttons_.size(); ++k) {
            const bool on = unsigned(now) >> (buttons_.size() - 1 - k) & 1U;
            buttons_[k]->setChecked(on);
            buttons_[k]->setText(on ? QStringLiteral("1") : QStringLiteral("0"));
            buttons_[k]->setAccessibleName(
                QStringLiteral("%1: %2").arg(move->bits[k], buttons_[k]->text()));
        }
    if (slider_) {
        const QSignalBlocker quiet(slider_);
        slider_->setValue(qRound(now * placesOfSlider));
    }
    if (line_ && line_->value() != int(now)) { // not while it is typed
        const QSignalBlocker quiet(line_);
        line_->setValue(int(now));
    }
    if (value_ && settled)
        value_->setText(app::shortText(now));
}

QWidget* MoveInput::first() const
{
    if (slider_)
        return slider_;
    if (line_)
        return line_;
    if (value_)
        return value_;
    const auto open = std::ranges::find_if(buttons_, &QWidget::isEnabled);
    return open == buttons_.end() ? nullptr : *open;
}

bool MoveInput::isChecked() const
{
    const app::Move* move = practice_.move();
    return move && move->kind != app::MoveKind::Edge && move->kind != app::MoveKind::Decide;
}

void MoveInput::check()
{
    if (!value_)
        return practice_.check();
    const auto number = numberIn(value_->text());
    if (number)
        return practice_.answer(*number.value);
    emit refused(Text::tr("“%1” is not a number. Type one, such as 0.25 or 1/4.")
                     .arg(value_->text().trimmed()));
}

} // namespace ui

#include "moc_move_input.cpp"
