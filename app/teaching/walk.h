// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"
#include "app/comparison/outcode_text.h"
#include "app/comparison/variants.h"
#include "app/document/subpath.h"

#include <QString>
#include <QStringList>

namespace app {

/// What the timeline shows of a step.
enum class Mark : std::uint8_t { Look, Compare, Divide, Cut, Accept, Reject, GiveUp };

/// A variable after a step.
struct Variable {
    QString name; ///< as in the pseudo-code: "x1", "t"
    double value = 0;
    clipping::ValueKind kind = clipping::ValueKind::Number;
    std::optional<double> before{}; ///< its value one step earlier; nothing: it is new
    bool changed() const
    {
        return !before || !(*before == value || (*before != *before && value != value));
    }
};

/// One step, as people read it.
struct Moment {
    Mark mark = Mark::Look;
    int line = 0;                    ///< of the pseudo-code, from 1; 0: none
    QString sentence;                ///< what happens, in plain words
    std::vector<Variable> variables; ///< all that are known by now; those of End 1 and 2 first
    clipping::Segment left{};        ///< what is left of the line, if it is not rejected
    clipping::Edge edge = clipping::Edge::None; ///< the edge that it is about
    std::optional<Point> candidate{}; ///< where the line may be cut: of a parameter just found
    clipping::OperationCounts cost{}; ///< since the start
    std::optional<bool> answer{};     ///< of a test
};

/// A whole trace, as people read it. The steps are the library's own, so they cannot drift from
/// what it does.
struct Walk {
    QStringList code;              ///< the pseudo-code
    std::vector<Moment> moments{}; ///< none where there is nothing to trace: see `refusal`
    clipping::Outcome outcome = clipping::Outcome::Invisible;
    std::optional<clipping::Segment> visible{}; ///< what the form's clip returns, bit for bit
    QString refusal{}; ///< why there are no steps: "x1 is not a number", "the window …"
};
Walk walkOf(const Specimen& specimen);

/// The shortest text that is the number, with a real minus: "−9.0625".
QString exactText(double value);
/// Six digits at most, for sentences.
QString shortText(double value);
/// What a variable holds, for people: bits as an outcode, a truth as yes or no.
QString valueText(const Variable& variable);

} // namespace app
