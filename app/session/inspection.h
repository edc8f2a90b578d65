// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/line_class.h"
#include "app/session/session.h"

#include <QString>
#include <QStringList>

namespace app {

/// The explanation of one line at the compared window.
struct Inspection {
    /// The variant that is explained. For a line that differs between A and B, while a panel shows
    /// it: A, or B if A is `exact`, which is never wrong. Otherwise the chosen variant.
    Variant variant{};
    std::size_t number = 0; ///< in the scene's lines
    std::size_t object = 0; ///< the object of the line
    clipping::Segment segment{};
    unsigned fromCode = 0, toCode = 0; ///< outcodes of the ends
    LineClass lineClass = LineClass::Inside;
    std::optional<clipping::Segment> visible{}; ///< the part that the algorithm leaves
    double share = 0;                           ///< share of the length; for a point: 1 if visible
    clipping::OperationCounts cost{};
    clipping::Trace trace{};
};
Inspection inspect(const Session& session, std::size_t segment);
/// The first line of the only selected object; empty: there is none, or there are several.
std::optional<std::size_t> lineOfOnlyObject(const Session& session);
/// The variant that is explained for a line: Inspection::variant.
Variant explaining(const Session& session, std::size_t segment);

/// "LB as published: visible, 71.7 %", "KWC as published: nothing visible".
QString verdictText(const Inspection& inspection);
/// "14 comparisons, 4 additions, 1 multiplication"; counts of 0 are left out; "nothing" if all are
/// 0.
QString costText(const clipping::OperationCounts& cost);
/// A text for each step of the trace except its tests, and one for the end: the action, its values
/// and the remaining part. Coordinates and lengths are in `unit`, as everywhere in the window. For
/// a known misprint also its defect.
QStringList stepTexts(const Inspection& inspection, Unit unit, const Page& page);

} // namespace app
