// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/subpath.h"

#include <QByteArray>

namespace app {

/// A letter of strokes. y down from the baseline, x from the middle of the letter; capitals are
/// `hersheyCapital` high.
struct HersheyGlyph {
    double left = 0, right = 0; ///< the room that the letter takes
    std::vector<std::vector<Point>> strokes{};
};
constexpr double hersheyCapital = 21;

/// The glyphs of a file in the format of James Hurt (*.jhf), in the order of the file. A row has a
/// number (5 characters), the number of pairs of characters (3), and the pairs: the first gives
/// left and right, " R" lifts the pen, every other is a point. A row may be broken over several
/// lines.
Result<std::vector<HersheyGlyph>> readHershey(const QByteArray& bytes);

} // namespace app
