// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// The clip windows as plain numbers, made once per change.
///
/// It is a set of points: those of the first step's window, or everything else than them, and so
/// on. Windows are closed, so a cut-out takes its border with it. What is kept of a line is the
/// closure, in the line, of its points in the set (with Keep::Outside: not in the set):
/// - pieces end on the border of the window that cuts them, also of a cut-out;
/// - pieces on both sides of an edge that two added windows share are one piece;
/// - a part along the border of a cut-out is removed, a part along that of an added window kept;
/// - a cut-out that a line meets in a single point removes nothing from it;
/// - a single point of a longer line that is in the set, and nothing beside it, is a contact: a
///   piece without length.
/// For one window these are the rules of `clipping::Uses` (inside) and `clipping::outsideAll`.
struct ClipRegion {
    struct Step {
        clipping::Window box; ///< contains nothing if `min > max` or a number is not finite
        WindowOperation operation;
        friend bool operator==(const Step&, const Step&) = default;
    };
    std::vector<Step> steps{};
    Keep keep = Keep::Inside;
    friend bool operator==(const ClipRegion&, const ClipRegion&) = default;

    /// There is no window: nothing is cut.
    bool everything() const { return steps.empty(); }
    /// The set begins with all points; else with none.
    bool startsFull() const
    {
        return everything() || steps.front().operation != WindowOperation::Add;
    }
    /// The window if the set is one rectangle. `keep` may be either.
    std::optional<clipping::Window> single() const;
};

/// The visible windows that are axis-aligned rectangles; other shapes are left out.
ClipRegion regionOf(const ClipWindows& windows);

/// What is kept of everything in a box; Pieces where that depends on the lines themselves.
enum class Remains : std::uint8_t { Gone, Whole, Pieces };

/// Gone and Whole are never wrong: a line with both ends in the closed box is gone, or comes back
/// whole. Pieces for an inverted box and one with a number that is not finite, unless nothing is
/// cut.
Remains remainsOf(const ClipRegion& region, const clipping::Window& box);

/// Folds what an algorithm leaves of one line inside each step's window into the pieces that are
/// kept, and appends these in the line's order. `atStep` has an element for each step. Each end is
/// one of the line's or of a piece's, bit for bit. `Clipped::cut` names the edge of the window
/// that the end is on, Edge::None for an end of the line; its level is the end's own coordinate
/// across that edge. `source` is put into every piece.
///
/// One rectangle gives the algorithm's piece or `outsideAll` of it, bit for bit. Of several
/// windows, ends on the same level of an axis are one place if they differ by no more than an
/// algorithm may round (128 ulps of the largest coordinate); the first stands for all. A piece that
/// is not finite counts as nothing; one that runs the other way (a published form) is turned.
void fold(const ClipRegion& region, const clipping::Segment& line, std::uint32_t source,
          std::span<const std::optional<clipping::Clipped>> atStep,
          std::vector<clipping::Clipped>& kept);

} // namespace app
