// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"

#include "app/base/random.h"
#include "app/base/text.h"
#include "app/lessons/attempt.h"
#include "app/lessons/opened_lessons.h"

#include <QRandomGenerator>
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
    if (!lessonAt(lesson))
        return;
    left_.reset();
    lesson_ = lesson;
    page_ = 0;
    answers_.assign(pages(), {});
    seeds_.assign(pages(), 0);
    std::uint64_t seed = newSeed();
    for (std::uint64_t& one : seeds_)
        one = seed == 0 ? 0 : seed = mixed(seed);
    setPages(this->lesson()->pages);
    showAgain();
}

/// The seed of an attempt, or of a page that is drawn once more.
std::uint64_t Course::newSeed() const
{
    return seed_ ? *seed_ : QRandomGenerator::global()->generate64();
}

/// The pages as the lesson's file has them.
void Course::setPages(const std::vector<LessonPage>& pages)
{
    drawn_ = pages;
    isDrawn_.assign(pages.size(), 0);
}

/// Draws the line of the current page, unless that is done: one page a time, because it takes
/// a millisecond.
void Course::draw()
{
    if (!std::exchange(isDrawn_[page_], 1))
        drawn_[page_] = drawnPage(drawn_[page_], seeds_[page_]);
}

void Course::beginOrGoOn(std::size_t lesson)
{
    if (!lesson_ && left_ && left_->lesson == lesson) {
        lesson_ = lesson;
        page_ = left_->page;
        answers_ = std::move(left_->answers);
        seeds_ = std::move(left_->seeds);
        left_.reset();
        setPages(this->lesson()->pages);
        if (isOpen()) // its line may have been looked at meanwhile
            seeds_[page_] = newSeed();
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
    leave();
    if (covers)
        microscope_.close();
    emit changed();
}

void Course::setAside()
{
    if (!lesson())
        return;
    leave();
    emit changed();
}

void Course::leave()
{
    if (atEnd())
        left_.reset();
    else if (lesson_)
        left_ = Left{*lesson_, page_, answers_, seeds_};
    lesson_.reset();
    question_.reset();
    answers_.clear();
    seeds_.clear();
    drawn_.clear();
    paused_ = false;
}

std::optional<std::size_t> Course::lessonToGoOn() const
{
    return lesson_ ? lesson_ : left_ ? std::optional(left_->lesson) : std::nullopt;
}

const Lesson* Course::lesson() const { return lesson_ ? lessonAt(*lesson_) : nullptr; }

LessonParts Course::shows() const { return lesson() && !paused_ ? here().shows : LessonParts{}; }

QString Course::told() const
{
    if (isOpen())
        return {};
    const LessonPage& page = here();
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
    if (!lesson())
        return;
    draw();
    show(TracedLine(ownLine()));
}

/// The line that the page shows: its own, or of a settled question the one that was asked about.
const TracedLine& Course::ownLine() const
{
    const TracedLine& own = here().tracedLine;
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
    const LessonPage page = about(here(), tracedLine);
    const Narration narration = narrationOf(tracedLine);
    const auto wanted = stepFor(page, narration);
    asked_ = tracedLine;
    question_.reset();
    if (wanted && tracedLine.corners.empty()) // questions are about rectangles
        question_ = questionOf(page, narration, *wanted);
    if (question_)
        question_ = inNewOrder(*question_, seeds_[page_]);
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

bool Course::isOpen() const { return lesson() && here().question && !answer().settled(); }

void Course::choose(int choice)
{
    if (!asks() || choice < 0 || choice >= question_->choices.size()
        || std::ranges::count(answer().tries, choice) > 0)
        return;
    Answer& answer = answers_[page_];
    answer.about = asked_;
    answer.tries.push_back(choice);
    answer.right = choice == question_->right;
    if (!answer.right)
        ++answer.wrong;
    settle();
}

void Course::showAnswer()
{
    if (!isOpen())
        return;
    if (!question_)
        ask(here().tracedLine);
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
            int(std::ranges::count_if(answers_, &Answer::rightAtOnce))};
}

QString Course::ending() const
{
    const int questions = lesson() ? questionsOf(*lesson()) : 0, right = score().right;
    if (!atEnd() || questions == 0)
        return {};
    if (isPassed(right, *lesson()))
        return Text::tr("Passed: %1 of %2 right at the first try.").arg(right).arg(questions);
    return Text::tr("Not passed yet: %1 of %2 right at the first try, and %3 are needed. Try the "
                    "lesson again? It then has other lines.")
        .arg(right)
        .arg(questions)
        .arg(neededRight(*lesson()));
}

namespace {

QString keyOf(const Lesson& lesson) { return QStringLiteral("lessons/right/") + lesson.key; }

/// The probability that of questions with so many choices at least `least` are answered right by
/// chance.
double chanceOf(int least, const std::vector<int>& choices)
{
    std::vector<double> right{1}; // the probability of each number of right answers
    for (const int count : choices) {
        right.push_back(0);
        for (std::size_t k = right.size() - 1; k > 0; --k)
            right[k] += (right[k - 1] - right[k]) / count;
        right[0] -= right[0] / count;
    }
    return std::accumulate(right.begin() + least, right.end(), 0.0);
}

} // namespace

int questionsOf(const Lesson& lesson)
{
    return int(std::ranges::count_if(
        lesson.pages, [](const LessonPage& page) { return page.question.has_value(); }));
}

int neededRight(const Lesson& lesson)
{
    constexpr double mostChance = 0.0065;
    std::vector<int> choices;
    for (const LessonPage& page : lesson.pages)
        if (page.question)
            choices.push_back(std::max(1, choicesOf(*page.question)));
    const int all = int(choices.size());
    int needed = (2 * all + 2) / 3;
    while (needed < all && chanceOf(needed, choices) > mostChance)
        ++needed;
    return needed;
}

bool isPassed(int right, const Lesson& lesson)
{
    return questionsOf(lesson) > 0 && right >= neededRight(lesson);
}

std::optional<int> bestRight(const QSettings& settings, const Lesson& lesson)
{
    bool isNumber = false;
    const int right = settings.value(keyOf(lesson)).toInt(&isNumber);
    return isNumber ? std::optional(std::clamp(right, 0, questionsOf(lesson))) : std::nullopt;
}

void keepRight(QSettings& settings, const Lesson& lesson, int right)
{
    if (right > bestRight(settings, lesson).value_or(-1))
        settings.setValue(keyOf(lesson), std::clamp(right, 0, questionsOf(lesson)));
}

} // namespace app

#include "moc_course.cpp"
