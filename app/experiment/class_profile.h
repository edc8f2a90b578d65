// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/class_lines.h"
#include "app/experiment/record.h"

namespace app {

/// What lines of one class cost: an experiment on them alone.
struct ClassTimes {
    ClassLines of; ///< without the lines
    Record record; ///< no timings if the scene has no such lines
};

/// Why an algorithm is fast for one scene and slow for another: each class by itself, clipping
/// only, in the order of lineClasses.
struct ClassProfile {
    ExperimentOptions options; ///< the scene as a whole
    std::vector<ClassTimes> classes;
};

/// How many lines of each class are timed, if the scene has them: a tenth of the lines, 100,000 at
/// most.
std::size_t mostOfAClass(const ExperimentOptions& options);

/// Up to mostOfAClass lines of each class of the scene; `runs`, `seed` and the field are the
/// options'. Nothing if it was stopped. Progress goes from 0 to 1 over all classes.
std::optional<ClassProfile> classProfile(const ExperimentOptions& options,
                                         std::span<const Variant> variants,
                                         const Follower& follower = {});

/// One row a variant: median nanoseconds a line of each class, and what a line of the scene
/// costs if each costs what its class does.
Table classTable(const ClassProfile& profile);

} // namespace app
