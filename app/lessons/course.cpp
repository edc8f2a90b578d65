// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"

#include <algorithm>

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
    answers_.assign(pages(), std::nullopt);
    right_.assign(pages(), false);
    show();
}

void Course::end()
{
    lesson_.reset();
    question_.reset();
    answers_.clear();
    right_.clear();
    emit changed();
}

const Lesson* Course::lesson() const { return lesson_ ? &lessons()[*lesson_] : nullptr; }

void Course::next()
{
    if (lesson() && !atLastPage()) {
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

void Course::show()
{
    const LessonPage& page = lesson()->pages[page_];
    microscope_.open(page.specimen);
    microscope_.goTo(wantedStep(page, microscope_.walk()));
    question_ = questionOf(page, microscope_.walk(), microscope_.step());
    emit changed();
}

void Course::choose(int choice)
{
    if (!question_ || answer() || choice < 0 || choice >= question_->choices.size())
        return;
    answers_[page_] = choice;
    right_[page_] = choice == question_->right;
    emit changed();
}

Score Course::score() const
{
    return {int(std::ranges::count_if(answers_, [](const auto& a) { return a.has_value(); })),
            int(std::ranges::count(right_, true))};
}

int Course::questions() const
{
    if (!lesson())
        return 0;
    return int(std::ranges::count_if(lesson()->pages,
                                     [](const LessonPage& p) { return p.question.has_value(); }));
}

} // namespace app
