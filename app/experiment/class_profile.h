// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/class_lines.h"
#include "app/experiment/record.h"

namespace app {

/// The times of lines of one class: an experiment on these lines alone.
struct ClassTimes {
    ClassLines of; ///< without the lines
    Record record; ///< no timings if the scene has no such lines
};

/// Why an algorithm is fast for one scene and slow for another: the times of each class alone,
/// clipping only, in the order of lineClasses.
struct ClassProfile {
    ExperimentOptions options; ///< the scene as a whole
    std::vector<ClassTimes> classes;
};

/// How many lines of each class are timed, if the scene has that many: a tenth of the lines, at
/// most 100,000.
std::size_t mostOfAClass(const ExperimentOptions& options);

/// Times up to mostOfAClass lines of each class of the scene; `options` give runs, seed and field.
/// Empty if it was stopped. Progress goes from 0 to 1 over all classes.
std::optional<ClassProfile> classProfile(const ExperimentOptions& options,
                                         std::span<const Variant> variants,
                                         const Follower& follower = {});

/// A row for each variant: median nanoseconds per line of each class, and the mean of these
/// weighted by the shares of the classes in the scene.
Table classTable(const ClassProfile& profile);

} // namespace app
