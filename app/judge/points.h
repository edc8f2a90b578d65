// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/verdict.h"

namespace app::plug_in {

/// What a category gives where every line of it is right.
inline constexpr int fullPoints = 10;

/// A point for each whole tenth that is right, of the visible or of the invisible lines, whichever
/// is less: who drops every line, or keeps every one, gets none. The last point only where all are
/// right; a line that was not tested is not right.
int pointsOf(const CategoryCount& count);

/// One row of the catalogue of degrees.
struct Degree {
    int points;   ///< at least so many
    QString key;  ///< in files: "nearly"
    QString name; ///< "nearly right", translated
};
/// The best first.
std::span<const Degree> degrees();
const Degree& degreeOf(const CategoryCount& count);

/// All categories of a verdict together.
struct Score {
    int points = 0, most = 0;
    std::size_t right = 0, categories = 0; ///< how many have full points, and how many there are
};
Score scoreOf(const Verdict& verdict);

} // namespace app::plug_in
