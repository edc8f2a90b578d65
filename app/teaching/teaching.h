// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/family.h"
#include "app/teaching/sentence.h"
#include "app/teaching/value_unit.h"

#include <span>

// How an algorithm is explained: a file in sentences/ and a line in sentences/catalogue.cpp. An
// algorithm without a row uses the defaults, which need only its trace and its pseudo-code.

namespace app {

/// A typical line for an algorithm in the paper's window (y up), and the step of the corrected form
/// that its page shows.
struct PageFigure {
    clipping::Segment line{{-160, -30}, {70, 130}}; ///< the default: cut at two edges
    Mark mark = Mark::Cut;                          ///< the last step with this mark
};

/// One row. Everything except the key is optional.
struct Teaching {
    std::string_view key; ///< of the algorithm
    /// The sentence of a step; if it is empty, that of generalSentence is used. A row with its own
    /// sentences has one for every step of ordinary lines; only that of Accept may be the general
    /// one.
    QString (*sentence)(const SentenceContext& context) = generalSentence;
    std::string_view parameter{}; ///< the value that is the parameter of a candidate cut
    std::array<std::string_view, 2> middle{}; ///< or the two values that are its coordinates
    Overlay (*overlay)(const OverlayContext& context) =
        traceOverlay; ///< the algorithm's view of the plane
    PageFigure figure{};
    /// The units of variables that differ from the usual ones (value_unit.cpp); `published`: names
    /// that the published code uses differently. A row with its own sentences or units has
    /// the units of all its numbers; a number without a unit is dimensionless.
    std::span<const VariableUnit> variables{}, published{};
};

/// All rows.
std::span<const Teaching> teachings();
/// The row of an algorithm; the defaults if it has none.
Teaching teachingOf(const clipping::Algorithm& algorithm);

/// A step's sentence by that row; never empty.
QString sentenceOf(const Teaching& teaching, const SentenceContext& context);

} // namespace app
