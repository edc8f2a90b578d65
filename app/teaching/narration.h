// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"
#include "app/comparison/line_class.h"
#include "app/comparison/variants.h"
#include "app/document/subpath.h"

#include <QString>
#include <QStringList>

namespace app {

/// The symbol of a step on the timeline.
enum class Mark : std::uint8_t { Look, Compare, Divide, Cut, Accept, Reject, GiveUp };

/// A variable after a step.
struct Variable {
    QString name; ///< as in the pseudo-code: "x1", "t"
    double value = 0;
    clipping::ValueKind kind = clipping::ValueKind::Number;
    std::optional<double> before{}; ///< its value one step earlier; empty: the variable is new
    bool changed() const
    {
        return !before || !(*before == value || (*before != *before && value != value));
    }
};

/// One step as people read it.
struct NarratedStep {
    Mark mark = Mark::Look;
    int line = 0;                    ///< of the pseudo-code, from 1; 0: none
    QString sentence;                ///< what happens, in plain words
    std::vector<Variable> variables; ///< all known so far; those of End 1 and 2 first
    clipping::Segment left{};        ///< the remaining part of the line, if it is not rejected
    clipping::Edge edge = clipping::Edge::NoEdge; ///< the edge of this step
    std::size_t polygonEdge = 0;                  ///< of a polygonal window, from 1; 0: none
    std::optional<Point> candidate{}; ///< a candidate cut, from a parameter just computed
    clipping::OperationCounts cost{}; ///< since the start
    std::optional<bool> answer{};     ///< the result of a test
};

/// A whole trace as people read it. The steps are the library's own, so that they always match its
/// computation.
struct Narration {
    QStringList code;                  ///< the pseudo-code
    std::vector<NarratedStep> steps{}; ///< empty if there is no trace: see `refusal`
    clipping::Outcome outcome = clipping::Outcome::Invisible;
    std::optional<clipping::Segment> visible{}; ///< the result of the form's clip, bit for bit
    QString refusal{}; ///< why there are no steps: "x1 is not a number", "the window …"
};

/// How the sentences are: explained by the algorithm's own, which also say what follows from a
/// step; or plain, which only fill the numbers into the line of the pseudo-code.
enum class Sentences : std::uint8_t { Explained, Plain };
Narration narrationOf(const TracedLine& tracedLine, Sentences sentences = Sentences::Explained);

/// A variable's value for people: bits as an outcode, a truth value as yes or no.
QString valueText(const Variable& variable);

} // namespace app
