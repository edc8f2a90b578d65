// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/microscope.h"

#include <algorithm>

namespace app {

namespace {

/// The visible part of a trace while a question about it is open.
Narration firstSteps(Narration narration, std::size_t shown)
{
    if (narration.steps.size() > shown)
        narration.steps.resize(shown);
    narration.outcome = clipping::Outcome::Invisible;
    narration.visible.reset();
    return narration;
}

} // namespace

void Microscope::open(const TracedLine& tracedLine, std::size_t step)
{
    shown_.reset();
    sentences_ = Sentences::Explained;
    show(tracedLine, step);
}

void Microscope::openCovered(const TracedLine& tracedLine, std::size_t shown, Sentences sentences)
{
    shown_ = shown;
    sentences_ = sentences;
    show(tracedLine, shown > 0 ? shown - 1 : 0);
}

void Microscope::show(const TracedLine& tracedLine, std::size_t step)
{
    step_ = step;
    setTracedLine(tracedLine);
    if (!open_) {
        open_ = true;
        emit openChanged();
    }
}

void Microscope::close()
{
    if (!open_)
        return;
    open_ = false;
    shown_.reset();
    sentences_ = Sentences::Explained;
    emit openChanged();
}

void Microscope::setTracedLine(const TracedLine& tracedLine)
{
    tracedLine_ = tracedLine;
    narration_ = narrationOf(tracedLine_, sentences_);
    if (shown_)
        narration_ = firstSteps(std::move(narration_), *shown_);
    step_ = std::min(step_, std::max<std::size_t>(narration_.steps.size(), 1) - 1);
    emit tracedLineChanged();
}

const NarratedStep* Microscope::narrated() const
{
    return narration_.steps.empty() ? nullptr : &narration_.steps[step_];
}

void Microscope::goTo(std::size_t step)
{
    step = std::min(step, std::max<std::size_t>(narration_.steps.size(), 1) - 1);
    if (step == step_)
        return;
    step_ = step;
    emit stepChanged();
}

} // namespace app

#include "moc_microscope.cpp"
