// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/family.h"
#include "app/teaching/teller.h"
#include "app/teaching/value_unit.h"

#include <span>

// How an algorithm is taught: a file in tellers/ and a line in tellers/catalogue.cpp. An
// algorithm without a row of its own is taught by the defaults, which need its trace and its
// pseudo-code only.

namespace app {

/// A line in the paper's window (y up) that tells something about an algorithm, and the step of its
/// corrected form that is shown on its page.
struct PageFigure {
    clipping::Segment line{{-160, -30}, {70, 130}}; ///< the default: cut at two edges
    Mark mark = Mark::Cut;                          ///< the last step of this kind
};

/// One row. All but the key is optional.
struct Teaching {
    std::string_view key; ///< of the algorithm
    /// How a step is said; empty: as generalSentence says it.
    QString (*sentence)(const Telling& telling) = generalSentence;
    std::string_view parameter{}; ///< the value that says how far along the line a cut may be
    std::array<std::string_view, 2> middle{}; ///< or the two that are the point itself
    Overlay (*overlay)(const Seeing& seeing) = traceOverlay; ///< what it sees of the plane
    PageFigure figure{};
    /// The units of its variables where they are not the usual ones (value_unit.cpp); `published`:
    /// where the published code uses a name for something else. A number without a unit is bare.
    std::span<const VariableUnit> variables{}, published{};
};

/// The rows that there are.
std::span<const Teaching> teachings();
/// The row of an algorithm; one without a row has the defaults.
Teaching teachingOf(const clipping::Algorithm& algorithm);

/// A step's sentence by such a row; never empty.
QString sentenceOf(const Teaching& teaching, const Telling& telling);

} // namespace app
