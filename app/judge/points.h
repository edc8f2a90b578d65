// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/verdict.h"

namespace app::plug_in {

/// The points of a category without wrong lines.
inline constexpr int fullPoints = 10;

/// One point for each whole tenth that is right of the visible or of the invisible lines, whichever
/// is less: a library that drops every line, or keeps every line, gets none. The last point needs
/// all lines right; an untested line is not right.
int pointsOf(const CategoryCount& count);

/// One row of the catalogue of grades.
struct Degree {
    int points;   ///< the least number of points
    QString key;  ///< in files: "nearly"
    QString name; ///< "nearly right", translated
};
/// The best first.
std::span<const Degree> degrees();
const Degree& degreeOf(const CategoryCount& count);

/// The sum over all categories of a verdict.
struct Score {
    int points = 0, most = 0;
    std::size_t right = 0, categories = 0; ///< number of categories with full points, and of all
};
Score scoreOf(const Verdict& verdict);

} // namespace app::plug_in
