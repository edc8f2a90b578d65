// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/plan.h"
#include "app/teaching/narration.h"
#include "clipping/pseudo_code.h"

#include <optional>
#include <span>

namespace app {

/// A step at which a plan asks.
struct MoveContext {
    const TracedLine& tracedLine;
    const Narration& narration;
    const clipping::Trace& trace; ///< the same steps, with their labels
    const std::vector<clipping::CodeLine>& code;
    const PlannedMove& planned;
    std::size_t step; ///< index

    const NarratedStep& now() const { return narration.steps[step]; }
    const clipping::Step& traced() const { return trace.steps[step]; }
    /// What is left of the line before a step; before the first: the line.
    clipping::Segment leftBefore(std::size_t index) const;
    /// The next step, from this one on, that moves an end; empty if a step with this step's label
    /// comes first.
    std::optional<std::size_t> nextCut() const;
    /// The end that a cut moves, 1 or 2; empty if none moves.
    std::optional<int> movedEnd(std::size_t cut) const;
    /// The point that the end of this number is at before this step.
    Point endBefore(int end) const;
    QString codeText(int line) const; ///< without indentation
};

/// A kind of move: a file here and a line in catalogue.cpp.
struct MoveMaker {
    MoveKind kind;
    /// Empty if the step gives no such move: then the algorithm does it itself.
    std::optional<Move> (*make)(const MoveContext& context);
    QString (*text)(const Move& move, double answer, YAxis y); ///< an answer in words
    const char* alsoIn = nullptr;                              ///< alsoIn(), not translated
};
const MoveMaker& makerOf(MoveKind kind);

/// Whether a word is one of those that blanks separate.
inline bool isWordOf(std::string_view word, std::string_view words)
{
    return clipping::CodeLine{{}, words}.has(word);
}

/// Adds a mistake unless it is right, or a mistake with nearly the same answer is there already.
void addMistake(Move& move, std::string_view kind, double answer, const QString& hint);

} // namespace app
