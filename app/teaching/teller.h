// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <array>
#include <span>

// How the steps of one algorithm are said: a file in tellers/ and a line in tellers/catalogue.cpp.

namespace app {

/// What a sentence can be made of.
struct Telling {
    const Specimen& specimen;
    const clipping::Step& step;
    const clipping::Step* before; ///< null: it is the first
    std::span<const Variable> variables{}; ///< all that are known by now
    clipping::Edge edge() const { return step.edge; }
    /// "the top edge".
    QString edgeText() const { return edgeWords(step.edge, specimen.y); }
    /// A value that the step tells; nothing: it tells none of that name.
    std::optional<double> value(std::string_view name) const;
    /// A variable's value by now; nothing: it has none yet.
    std::optional<double> known(std::string_view name) const;
    /// The same as text of six digits.
    QString text(std::string_view name) const;
    /// Whether the test held; false for what is no test.
    bool holds() const { return step.holds; }
};

/// One row: how an algorithm's steps are said.
struct Teller {
    std::string_view key;                        ///< of the algorithm
    QString (*sentence)(const Telling& telling); ///< empty: the general words will do
    std::string_view parameter{}; ///< the value that says how far along the line a cut may be
    std::array<std::string_view, 2> middle{}; ///< or the two that are the point itself
};
std::span<const Teller> tellers();

/// What can be said of any algorithm's step.
QString generalSentence(const Telling& telling);

} // namespace app
