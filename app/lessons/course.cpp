// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"

#include "app/lessons/scores.h"

#include <algorithm>
#include <numeric>

namespace app {

Course::Course(Microscope& microscope, QObject* parent) : QObject(parent), microscope_(microscope)
{
}

void Course::begin(std::size_t lesson)
{
    if (lesson >= lessons().size())
        return;
    lesson_ = lesson;
    page_ = 0;
    answers_.assign(pages(), {});
    points_.assign(pages(), 0);
    show();
}

void Course::end()
{
    if (lesson() && microscope_.isOpen() && microscope_.isCovered())
        microscope_.open(microscope_.tracedLine(), microscope_.step());
    lesson_.reset();
    question_.reset();
    answers_.clear();
    points_.clear();
    emit changed();
}

const Lesson* Course::lesson() const { return lesson_ ? &lessons()[*lesson_] : nullptr; }

QString Course::told() const { return isOpen() ? QString() : lesson()->pages[page_].told; }

void Course::next()
{
    if (lesson() && !atLastPage() && !isOpen()) {
        ++page_;
        show();
    }
}

void Course::previous()
{
    if (lesson() && page_ > 0) {
        --page_;
        show();
    }
}

void Course::showAgain()
{
    if (lesson())
        show();
}

/// Covers the microscope's steps before it shows anything of the page.
void Course::show()
{
    const LessonPage& page = lesson()->pages[page_];
    const Narration narration = narrationOf(page.tracedLine);
    const std::size_t step = wantedStep(page, narration);
    question_ = questionOf(page, narration, step);
    if (isOpen())
        microscope_.openCovered(page.tracedLine, stepsShown(page, step));
    else
        microscope_.open(page.tracedLine, step);
    emit changed();
}

bool Course::isOpen() const
{
    if (!question_)
        return false;
    const auto& [tries, shown] = answer();
    return !shown && tries.size() < 2 && (tries.empty() || tries.back() != question_->right);
}

void Course::choose(int choice)
{
    if (!isOpen() || choice < 0 || choice >= question_->choices.size()
        || std::ranges::count(answer().tries, choice) > 0)
        return;
    Answer& answer = answers_[page_];
    answer.tries.push_back(choice);
    if (choice == question_->right)
        points_[page_] = answer.tries.size() == 1 ? 2 : 1;
    settle();
}

void Course::showAnswer()
{
    if (!isOpen())
        return;
    answers_[page_].shown = true;
    settle();
}

/// If the question is no longer open, uncovers the steps.
void Course::settle() { isOpen() ? emit changed() : show(); }

Score Course::score() const
{
    const auto settled = std::ranges::count_if(answers_, [this](const Answer& answer) {
        return answer.shown || answer.tries.size() >= 2
               || points_[std::size_t(&answer - answers_.data())] > 0;
    });
    return {int(settled), std::accumulate(points_.begin(), points_.end(), 0)};
}

int Course::rightWorth(int points) const { return int(std::ranges::count(points_, points)); }

QString Course::ending() const
{
    const int questions = lesson() ? mostPoints(*lesson()) / 2 : 0;
    if (!atEnd() || questions == 0)
        return {};
    QString text = tr("%1 of %2 right at the first try").arg(rightWorth(2)).arg(questions);
    if (const int second = rightWorth(1); second > 0)
        text += tr(", %1 at the second").arg(second);
    if (isPassed(score().points, *lesson()))
        return tr("Passed: %1.").arg(text);
    return tr("Not passed yet: %1. You need three quarters of the points. Try the lesson again?")
        .arg(text);
}

} // namespace app
