// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/microscope.h"

#include <algorithm>

namespace app {

void Microscope::open(const Specimen& specimen)
{
    step_ = 0;
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
    emit openChanged();
}

void Microscope::setSpecimen(const Specimen& specimen)
{
    specimen_ = specimen;
    walk_ = walkOf(specimen_);
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
