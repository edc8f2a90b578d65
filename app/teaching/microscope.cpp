// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/microscope.h"

#include <algorithm>

namespace app {

namespace {

/// The visible part of a walk while a question about it is open.
Walk firstSteps(Walk walk, std::size_t shown)
{
    if (walk.moments.size() > shown)
        walk.moments.resize(shown);
    walk.outcome = clipping::Outcome::Invisible;
    walk.visible.reset();
    return walk;
}

} // namespace

void Microscope::open(const Specimen& specimen, std::size_t step)
{
    shown_.reset();
    show(specimen, step);
}

void Microscope::openCovered(const Specimen& specimen, std::size_t shown)
{
    shown_ = shown;
    show(specimen, shown > 0 ? shown - 1 : 0);
}

void Microscope::show(const Specimen& specimen, std::size_t step)
{
    step_ = step;
    setSpecimen(specimen);
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
    emit openChanged();
}

void Microscope::setSpecimen(const Specimen& specimen)
{
    specimen_ = specimen;
    walk_ = shown_ ? firstSteps(walkOf(specimen_), *shown_) : walkOf(specimen_);
    step_ = std::min(step_, std::max<std::size_t>(walk_.moments.size(), 1) - 1);
    emit specimenChanged();
}

const Moment* Microscope::moment() const
{
    return walk_.moments.empty() ? nullptr : &walk_.moments[step_];
}

void Microscope::goTo(std::size_t step)
{
    step = std::min(step, std::max<std::size_t>(walk_.moments.size(), 1) - 1);
    if (step == step_)
        return;
    step_ = step;
    emit stepChanged();
}

} // namespace app
