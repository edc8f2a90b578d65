// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <array>
#include <optional>
#include <span>

// How a step is put into words: by a row's own sentences (teaching.h), or by those for any
// algorithm.

namespace app {

/// What a sentence can be made of.
struct Telling {
    const Specimen& specimen;
    const clipping::Step& step;
    const clipping::Step* before;          ///< null: it is the first
    std::span<const Variable> variables{}; ///< all that are known by now
    clipping::Edge edge() const { return step.edge; }
    /// "the top edge".
    QString edgeText() const { return edgeWords(step.edge, specimen.y); }
    /// A value that the step tells; nothing: it tells none of that name.
    std::optional<double> value(std::string_view name) const;
    /// A variable's value by now; nothing: it has none yet.
    std::optional<double> known(std::string_view name) const;
    /// Whether the test held; false for what is no test.
    bool holds() const { return step.holds; }
};

/// The default sentence of a step: the lit line of the pseudo-code, with the numbers of its
/// variables: "At the left edge, is x1 < xmin? −160 < −100: yes."
QString generalSentence(const Telling& telling);

} // namespace app
