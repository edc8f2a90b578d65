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
    std::vector<clipping::Segment> lines; ///< may be empty: the scene has no such lines
    double share = 0;                     ///< of all lines of the scene that were examined
    QString standIn{}; ///< key of the other scene that the lines come from, if any
};

/// How many lines of an unlimited scene are examined to find `most` of each class: four million for
/// 100,000.
constexpr std::uint64_t linesLookedThrough(std::size_t most)
{
    return std::max<std::uint64_t>(400'000, 40 * std::uint64_t(most));
}

/// `most` lines of each class, or as many as there are among the first lines of the scene (all
/// lines of a drawing), in the order of lineClasses. Where an unlimited scene has fewer than 1,000
/// of a class, the catalogue's scene of that class replaces it; for the paper's scene, lines inside
/// have exactly the same distribution. The follower is asked every 50,000 lines; empty if it was
/// stopped.
std::optional<std::array<ClassLines, lineClasses.size()>>
linesByClass(const TestScene& scene, const Field& field, std::uint64_t seed, std::size_t most,
             const Follower& follower = {});

} // namespace app
