// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/practice.h"

#include "app/base/text.h"
#include "app/practice/draw.h"
#include "clipping/pseudo_code.h"

#include <QRandomGenerator>
#include <QScopedValueRollback>

#include <algorithm>

namespace app {

Practice::Practice(Microscope& microscope, Course& course, QObject* parent)
    : QObject(parent), microscope_(microscope), course_(course)
{
    // Before any view of the microscope is connected, so that no view sees an answer.
    connect(&microscope, &Microscope::tracedLineChanged, this, &Practice::follow);
    connect(&course, &Course::changed, this, [this] {
        if (on_ && course_.lesson() && !course_.isPaused())
            leave();
    });
}

void Practice::begin(const Variant& variant)
{
    course_.setAside();
    traced_ = practiceLine(variant, seed_ ? *seed_ : QRandomGenerator::global()->generate64());
    moves_ = movesOf(traced_);
    answers_.assign(moves_.size(), {});
    isStep_.clear();
    for (const clipping::CodeLine& line :
         clipping::linesOf(clipping::codeOf(*variant.algorithm, variant.form)))
        isStep_.push_back(!line.labels.empty());
    on_ = true;
    paused_ = false;
    turnTo(0);
}

void Practice::turnTo(std::size_t index)
{
    index_ = index;
    note_.clear();
    draft_.reset();
    if (move() && move()->kind == MoveKind::Bits)
        draft_ = 0;
    else if (move() && move()->kind == MoveKind::Place)
        draft_ = 0.5;
    show();
}

void Practice::end()
{
    const bool covers = isOpen();
    leave();
    if (covers)
        microscope_.close();
}

void Practice::leave()
{
    if (!on_)
        return;
    on_ = paused_ = false;
    index_ = 0;
    moves_.clear();
    answers_.clear();
    emit changed();
}

void Practice::pause()
{
    paused_ = true;
    emit changed();
}

void Practice::goOn()
{
    paused_ = false;
    show();
}

/// While a move is open only the steps before it; afterwards those before the next one.
std::size_t Practice::stepsShown() const
{
    const std::size_t next = answers_[index_].settled() ? index_ + 1 : index_;
    return next < moves_.size() ? moves_[next].step : std::size_t(-1);
}

/// Shows the attempt's line, covered as far as needed, at the step of the move if it is settled.
void Practice::show()
{
    {
        const QScopedValueRollback quiet(showing_, true);
        constexpr std::size_t last = -1;
        const std::size_t shown = atEnd() ? last : stepsShown();
        shown == last ? microscope_.open(traced_, last)
                      : microscope_.openCovered(traced_, shown, Sentences::Plain);
        if (!atEnd() && answers_[index_].settled()) // the answer is about this one
            microscope_.goTo(moves_[index_].step);
    }
    emit changed();
}

/// Something else opens a line or drags an end: the attempt's line stays until it has ended.
void Practice::follow()
{
    if (!showing_ && on_ && !atEnd())
        show();
}

void Practice::answer(double answer)
{
    if (!asks())
        return;
    MoveAnswer& given = answers_[index_];
    if (std::ranges::count(given.tries, answer) > 0)
        return;
    const Move& move = moves_[index_];
    note_.clear();
    const auto line = std::size_t(std::max(1.0, answer)) - 1;
    if (move.kind == MoveKind::Line && (line >= isStep_.size() || !isStep_[line])) {
        note_ =
            line >= isStep_.size()
                ? Text::tr("There is no line %1.").arg(int(answer))
                : Text::tr("Line %1 computes and tests nothing. Choose the next line that does. "
                           "This does not count as a try.")
                      .arg(int(answer));
        emit changed();
        return;
    }
    given.tries.push_back(answer);
    given.right = isRight(move, answer);
    given.settled() ? show() : emit changed();
}

void Practice::showAnswer()
{
    if (!isOpen())
        return;
    note_.clear();
    answers_[index_].shown = true;
    show();
}

void Practice::next()
{
    if (!on_ || isOpen() || atEnd())
        return;
    turnTo(index_ + 1);
}

void Practice::setDraft(double draft)
{
    if (!asks() || draft_ == draft)
        return;
    draft_ = draft;
    emit draftChanged();
}

void Practice::check()
{
    if (draft_)
        answer(*draft_);
}

bool Practice::useDigit(int digit)
{
    if (!asks())
        return false;
    const Move& now = *move();
    if (now.kind == MoveKind::Bits && digit >= 1 && digit <= now.bits.size())
        setDraft(double(unsigned(draft_.value_or(0)) ^ 1U << (now.bits.size() - digit)));
    else if (now.kind == MoveKind::Edge && digit >= 1 && digit <= 4)
        answer(digit); // as clipping::Edge
    else if (now.kind == MoveKind::Decide && digit >= 1 && digit <= 3)
        answer(digit - 1); // as Decision
    else
        return false;
    return true;
}

QString Practice::verdict() const
{
    if (!note_.isEmpty())
        return note_;
    if (!on_ || !move())
        return {};
    const MoveAnswer& given = answers_[index_];
    if (given.right)
        return Text::tr("Right. %1").arg(move()->reason);
    if (given.settled())
        return correction(index_);
    if (given.tries.empty())
        return {};
    const Mistake* mistake = mistakeOf(*move(), given.tries.back());
    return Text::tr("Not quite. %1 You have one more try.")
        .arg(mistake ? mistake->hint : move()->hint);
}

int Practice::rightAtOnce() const
{
    return int(std::ranges::count_if(answers_, &MoveAnswer::rightAtOnce));
}

int Practice::needed() const { return neededFirstTries(moves_); }

QString Practice::ending() const
{
    if (!atEnd())
        return {};
    const int right = rightAtOnce(), all = int(moves_.size());
    return isPassed() ? Text::tr("Passed: %1 of %2 right at the first try.").arg(right).arg(all)
                      : Text::tr("Not passed yet: %1 of %2 right at the first try, and %3 are "
                                 "needed.")
                            .arg(right)
                            .arg(all)
                            .arg(needed());
}

std::vector<std::size_t> Practice::wrongMoves() const
{
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < answers_.size(); ++i)
        if (answers_[i].settled() && !answers_[i].rightAtOnce())
            wrong.push_back(i);
    return wrong;
}

QString Practice::correction(std::size_t index) const
{
    const Move& move = moves_[index];
    const MoveAnswer& given = answers_[index];
    QStringList answers;
    for (const double answer : given.tries)
        if (!isRight(move, answer))
            answers << answerText(move, answer, traced_.y);
    const QString right = answerText(move, move.right, traced_.y);
    return (answers.isEmpty() ? Text::tr("The answer is: %1. ").arg(right)
                              : Text::tr("You answered: %1. Right is: %2. ")
                                    .arg(answers.join(Text::tr(", then ")), right))
           + move.reason;
}

void Practice::lookAt(std::size_t move)
{
    if (!atEnd() || move >= moves_.size())
        return;
    microscope_.open(traced_, moves_[move].step);
    emit changed();
}

LessonParts Practice::shows() const
{
    return on_ && !paused_ ? LessonParts{.code = true, .variables = true, .steps = true}
                           : LessonParts{};
}

} // namespace app

#include "moc_practice.cpp"
