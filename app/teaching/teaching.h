// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/parts.h"
#include "app/teaching/narration.h"
#include "app/teaching/value_unit.h"

#include <array>
#include <optional>
#include <span>

// How a step is described in words: by the sentences of a row (teaching.h), or by the general ones.

namespace app {

/// The data of a sentence.
struct SentenceContext {
    const TracedLine& tracedLine;
    const clipping::Step& step;
    const clipping::Step* before;          ///< null: this is the first step
    std::span<const Variable> variables{}; ///< all known so far
    clipping::Edge edge() const { return step.edge; }
    /// "the top edge".
    QString edgeText() const { return edgeWords(step.edge, tracedLine.y); }
    /// A value of this step; empty if the step has no value of that name.
    std::optional<double> value(std::string_view name) const;
    /// The current value of a variable; empty if it has none yet.
    std::optional<double> known(std::string_view name) const;
    /// Whether the test held; false if the step is not a test.
    bool holds() const { return step.holds; }
    /// Whether the step is at a line of the pseudo-code with one of these labels.
    bool at(auto... labels) const { return ((step.label == std::string_view(labels)) || ...); }
};

/// The default sentence of a step: the current line of the pseudo-code, with the values of its
/// variables: "At the left edge, is x1 < xmin? −160 < −100: yes."
QString generalSentence(const SentenceContext& context);

} // namespace app

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
