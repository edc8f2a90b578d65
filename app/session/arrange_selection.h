// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/arrange.h"
#include "app/session/session.h"

namespace app {

/// A selected object, or a selected group as a whole.
struct ArrangedUnit {
    ObjectRanges objects;
    clipping::Window box;
};

/// The selection as units, from bottom to top, without objects that have no lines. A group is a
/// unit if all its objects are selected.
std::vector<ArrangedUnit> arrangedUnits(const Session& session);

/// The objects that the last step has added, as far as they may be edited; empty: it added none.
ObjectRanges justAdded(const Session& session);

/// What selected objects are aligned to: one row of a catalogue.
struct AlignmentTarget {
    std::string_view key;
    QString name;   ///< in the menu: "To the &page"
    QString listed; ///< in a list: "to page"
    bool isExtent;  ///< objects are also spread over it
    /// Empty: there is none now.
    std::optional<clipping::Window> (*box)(const Session& session,
                                           std::span<const ArrangedUnit> units);
};
std::span<const AlignmentTarget> alignmentTargets();
const AlignmentTarget& alignmentTarget(const Session& session); ///< the current one
/// How many objects are spread at least.
std::size_t leastSpread(const Session& session);

/// These change session.arrange, and are signalled as Session::displayChanged.
void alignTo(Session& session, const AlignmentTarget& target);
void scaleStrokes(Session& session, StrokeScaling strokes);

// Each is one undo step. Without enough units, or if nothing changes, they do nothing.
/// Aligns to what session.arrange names.
void align(Session& session, int axis, AlignTo side);
/// Spreads over what session.arrange names, if it is an extent, else between the outer two.
void spreadEvenly(Session& session, int axis);
void makeSameSize(Session& session, bool width, bool height);
/// Adds transformed copies of the selection, and selects them with the originals. False: there
/// would be too many objects.
bool repeatSelection(Session& session, std::span<const AffineMap> maps, const QString& undoText);

} // namespace app
