// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"

#include "app/base/text.h"

#include <QScopedValueRollback>
#include <QSettings>

#include <algorithm>
#include <numeric>
#include <utility>

namespace app {

namespace {

/// The page, about another line. Its own hint need not be true of that line.
LessonPage about(LessonPage page, const TracedLine& tracedLine)
{
    if (page.tracedLine != tracedLine)
        page.hint.clear();
    page.tracedLine = tracedLine;
    return page;
}

} // namespace

Course::Course(Microscope& microscope, QObject* parent) : QObject(parent), microscope_(microscope)
{
    // Before any view of the microscope is connected, so that no view sees an answer.
    connect(&microscope, &Microscope::tracedLineChanged, this, &Course::follow);
}

void Course::begin(std::size_t lesson)
{
    if (lesson >= lessons().size())
        return;
    left_.reset();
    lesson_ = lesson;
    page_ = 0;
    answers_.assign(pages(), {});
    points_.assign(pages(), 0);
    show(this->lesson()->pages[page_].tracedLine);
}

void Course::beginOrGoOn(std::size_t lesson)
{
    if (!lesson_ && left_ && left_->lesson == lesson) {
        lesson_ = lesson;
        page_ = left_->page;
        answers_ = std::move(left_->answers);
        points_ = std::move(left_->points);
        left_.reset();
        return showAgain();
    }
    if (lesson_ != lesson || atEnd())
        return begin(lesson);
    paused_ = false;
    emit changed();
}

void Course::pause()
{
    paused_ = true;
    emit changed();
}

void Course::end()
{
    const bool covers = lesson() && isOpen();
    if (atEnd())
        left_.reset();
    else if (lesson_)
        left_ = Left{*lesson_, page_, answers_, points_};
    lesson_.reset();
    question_.reset();
    answers_.clear();
    points_.clear();
    paused_ = false;
    if (covers)
        microscope_.close();
    emit changed();
}

std::optional<std::size_t> Course::lessonToGoOn() const
{
    return lesson_ ? lesson_ : left_ ? std::optional(left_->lesson) : std::nullopt;
}

const Lesson* Course::lesson() const { return lesson_ ? &lessons()[*lesson_] : nullptr; }

LessonParts Course::shows() const
{
    return lesson() && !paused_ ? lesson()->pages[page_].shows : LessonParts{};
}

QString Course::told() const
{
    if (isOpen())
        return {};
    const LessonPage& page = lesson()->pages[page_];
    const bool own = !question_ || asked_ == page.tracedLine || page.told.isEmpty();
    return own ? page.told : Text::tr("*Of the line on this page:* %1").arg(page.told);
}

void Course::next()
{
    if (lesson() && !atLastPage() && !isOpen()) {
        ++page_;
        showAgain();
    }
}

void Course::previous()
{
    if (lesson() && page_ > 0) {
        --page_;
        showAgain();
    }
}

void Course::showAgain()
{
    if (lesson())
        show(TracedLine(ownLine()));
}

/// The line that the page shows: its own, or of a settled question the one that was asked about.
const TracedLine& Course::ownLine() const
{
    const TracedLine& own = lesson()->pages[page_].tracedLine;
    return isOpen() || !answer().about ? own : *answer().about;
}

bool Course::isAway() const { return lesson() && microscope_.tracedLine() != ownLine(); }

/// Covers the microscope's steps before it shows anything of the line.
void Course::show(const TracedLine& tracedLine)
{
    paused_ = false;
    ask(tracedLine);
    away_ = isAway();
    emit changed();
}

/// Asks about a line and shows it.
void Course::ask(const TracedLine& tracedLine)
{
    const QScopedValueRollback quiet(showing_, true);
    const LessonPage page = about(lesson()->pages[page_], tracedLine);
    const Narration narration = narrationOf(tracedLine);
    const auto wanted = stepFor(page, narration);
    asked_ = tracedLine;
    question_.reset();
    if (wanted && tracedLine.corners.empty()) // questions are about rectangles
        question_ = questionOf(page, narration, *wanted);
    Answer& answer = answers_[page_];
    if (answer.about != tracedLine)
        answer.tries.clear();
    if (isOpen())
        microscope_.openCovered(tracedLine, question_ ? stepsShown(page, *wanted) : 0);
    else
        microscope_.open(tracedLine, wantedStep(page, narration));
}

/// The reader dragged an end, or the microscope was opened with another line: the open question is
/// about that line.
void Course::follow()
{
    if (showing_ || !lesson())
        return;
    const bool moved = std::exchange(away_, isAway()) != isAway();
    if (!isOpen() && moved)
        emit changed();
    if (!isOpen())
        return;
    const auto before = std::exchange(question_, std::nullopt);
    const std::size_t tries = answer().tries.size(), step = microscope_.step();
    ask(microscope_.tracedLine());
    microscope_.goTo(step); // as far as it is not covered
    if (moved || question_.has_value() != before.has_value() || answer().tries.size() != tries
        || (question_
            && (question_->prompt != before->prompt || question_->choices != before->choices)))
        emit changed();
}

bool Course::isOpen() const
{
    return lesson() && lesson()->pages[page_].question && !answer().settled();
}

void Course::choose(int choice)
{
    if (!asks() || choice < 0 || choice >= question_->choices.size()
        || std::ranges::count(answer().tries, choice) > 0)
        return;
    Answer& answer = answers_[page_];
    answer.about = asked_;
    answer.tries.push_back(choice);
    answer.right = choice == question_->right;
    if (answer.right)
        points_[page_] = answer.wrong == 0 ? 2 : 1;
    else
        ++answer.wrong;
    settle();
}

void Course::showAnswer()
{
    if (!isOpen())
        return;
    if (!question_)
        ask(lesson()->pages[page_].tracedLine);
    answers_[page_].about = asked_;
    answers_[page_].shown = true;
    settle();
}

void Course::skip()
{
    if (!isOpen())
        return;
    showAnswer();
    next();
}

/// If the question is no longer open, uncovers the steps.
void Course::settle() { isOpen() ? emit changed() : show(asked_); }

Score Course::score() const
{
    return {int(std::ranges::count_if(answers_, &Answer::settled)),
            std::accumulate(points_.begin(), points_.end(), 0)};
}

int Course::rightWorth(int points) const { return int(std::ranges::count(points_, points)); }

QString Course::ending() const
{
    const int questions = lesson() ? mostPoints(*lesson()) / 2 : 0;
    if (!atEnd() || questions == 0)
        return {};
    QString text = Text::tr("%1 of %2 right at the first try").arg(rightWorth(2)).arg(questions);
    if (const int second = rightWorth(1); second > 0)
        text += Text::tr(", %1 at the second").arg(second);
    if (isPassed(score().points, *lesson()))
        return Text::tr("Passed: %1.").arg(text);
    return Text::tr(
               "Not passed yet: %1. You need three quarters of the points. Try the lesson again?")
        .arg(text);
}

namespace {

QString keyOf(const Lesson& lesson) { return QStringLiteral("lessons/points/") + lesson.key; }

} // namespace

int mostPoints(const Lesson& lesson)
{
    return 2 * int(std::ranges::count_if(lesson.pages, [](const LessonPage& page) {
               return page.question.has_value();
           }));
}

bool isPassed(int points, const Lesson& lesson) { return 4 * points >= 3 * mostPoints(lesson); }

std::optional<int> bestPoints(const QSettings& settings, const Lesson& lesson)
{
    bool isNumber = false;
    const int points = settings.value(keyOf(lesson)).toInt(&isNumber);
    return isNumber ? std::optional(std::clamp(points, 0, mostPoints(lesson))) : std::nullopt;
}

void keepPoints(QSettings& settings, const Lesson& lesson, int points)
{
    if (points > bestPoints(settings, lesson).value_or(-1))
        settings.setValue(keyOf(lesson), std::clamp(points, 0, mostPoints(lesson)));
}

} // namespace app

#include "moc_course.cpp"
