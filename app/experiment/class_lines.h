// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/line_class.h"
#include "app/experiment/experiment.h"

#include <algorithm>
#include <array>

namespace app {

/// Lines of one class of a scene.
struct ClassLines {
    LineClass lineClass;
    std::vector<clipping::Segment> lines; ///< may be empty: the scene has none
    double share = 0;                     ///< of all lines of the scene, as far as it was looked at
    QString standIn{}; ///< key of the scene that the lines come from, if it is another one
};

/// How many lines of an endless scene are looked through for so many of each class: four million
/// for 100,000.
constexpr std::uint64_t linesLookedThrough(std::size_t most)
{
    return std::max<std::uint64_t>(400'000, 40 * std::uint64_t(most));
}

/// `most` lines of each class, or as many as there are among the first lines of the scene
/// (all of a drawing), in the order of lineClasses. Where an endless scene has fewer than a
/// thousand of a class, the scene of the catalogue that is made of that class stands in; for lines
/// inside of the paper's scene that is the very same distribution. The follower is asked every
/// 50,000 lines; nothing if it was stopped.
std::optional<std::array<ClassLines, lineClasses.size()>>
linesByClass(const TestScene& scene, const Field& field, std::uint64_t seed, std::size_t most,
             const Follower& follower = {});

} // namespace app
