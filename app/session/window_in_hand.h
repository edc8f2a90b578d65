// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/window_needs.h"
#include "app/session/session.h"

namespace app {

// The clip window that panels act on, as far as algorithms are concerned.

/// The window among the region's steps; null without a visible window, and for one without effect.
const ClipRegion::Step* stepInHand(const Session& session);
/// What it demands of an algorithm; a rectangle if there is none, since then nothing is cut.
WindowNeeds needsInHand(const Session& session);
/// The needs of each window that has an effect, with its name, in the order of the windows.
std::vector<NamedNeeds> needsByName(const Session& session);
/// "for Star: concave, 10 edges", "for a window: rectangle"; empty without a window, and for one
/// without effect.
QString headingInHand(const Session& session);

/// The variant that clips the drawing, whatever is chosen.
Variant usedVariant(const Session& session);

/// The window at which the microscope clips lines of the drawing: the window in hand if it is a
/// rectangle, also a rotated one, or a convex polygon; else `Session::window`. At a rectangle a
/// line is traced in the rectangle's own directions, in which it is along the axes, with the
/// numbers of the panel *Clip window*.
struct TracedWindow {
    WindowFrame frame;
    bool isPage = false;
    /// The corners of a convex polygon; then `frame` is its bounding box. Empty: a rectangle.
    std::vector<Point> corners{};
    /// The name of the window in hand if it has another shape, so that a rectangle is used.
    std::optional<QString> notAt{};
    /// Of several windows that have an effect: its name and how many there are. Empty: it is the
    /// only one.
    std::optional<std::pair<QString, std::size_t>> among{};

    clipping::Segment into(const clipping::Segment& line) const;
    /// Moves a traced line to this window; its line stays the same.
    void putInto(TracedLine& tracedLine) const;
    /// Says which window it is, to follow "Line 217 of 420", and that it is one of several; empty
    /// for the only one, along the axes.
    QString remark() const;
};
TracedWindow tracedWindow(const Session& session);

} // namespace app
