// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

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
