// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/page.h"
#include "clipping/region/region.h"
#include "clipping/turned_window.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// A region of the library that is prepared when it is first used: preparing one of many thousand
/// edges takes some tenths of a second, which the thread that only passes it on must not spend.
/// Owners on any threads may use it.
class LaterRegion {
public:
    explicit LaterRegion(clipping::Region region) : region_(std::move(region)) {}

    const clipping::PreparedRegion& prepared() const
    {
        std::call_once(once_, [this] {
            prepared_.emplace(region_);
            region_ = {};
        });
        return *prepared_;
    }

private:
    mutable std::once_flag once_;
    mutable clipping::Region region_; ///< until it is prepared
    mutable std::optional<clipping::PreparedRegion> prepared_;
};

/// The clip windows as plain numbers, rebuilt on each change.
///
/// The region is a set of points. It starts with no point, or with all points, and each step's
/// window adds to it, is cut out of it, or intersects it. Windows are closed, so a cut-out also
/// removes its border. The kept part of a line is the closure, within the line, of its points in
/// the set (with Keep::Outside: of its points not in the set):
/// - pieces end on the border of the window that cuts them, also for a cut-out;
/// - pieces on both sides of an edge shared by two added windows form one piece;
/// - a part along the border of a cut-out is removed, a part along that of an added window kept;
/// - a cut-out that a line meets in a single point removes nothing from the line;
/// - a single point of a longer line that is in the set, while its neighbours are not, is a
///   contact: a piece of length zero.
/// For a single window these are the rules of `clipping::Functions` (inside) and
/// `clipping::outsideAll`. A window without area contains nothing, alone or beside others.
struct ClipRegion {
    struct Step {
        clipping::Window box;      ///< contains nothing if `min > max` or a number is not finite
        WindowOperation operation; ///< never Replace: what a window replaces is no step
        /// The border of a window that is not an axis-aligned rectangle; `box` is its bounding box
        /// then.
        std::vector<std::vector<Point>> rings{};
        FillRule rule = FillRule::NonZero;
        /// The border as a convex polygon with area; without corners if it is none.
        clipping::ConvexPolygon polygon{};
        /// What is inside the border, for boxes; null for an axis-aligned rectangle.
        std::shared_ptr<const LaterRegion> area{};
        /// A rotated rectangle, if the polygon is one.
        std::optional<clipping::TurnedWindow> turned{};
        friend bool operator==(const Step& a, const Step& b)
        {
            return a.box == b.box && a.operation == b.operation && a.rings == b.rings
                   && a.rule == b.rule;
        }
    };
    std::vector<Step> steps{};
    Keep keep = Keep::Inside; ///< if there is a `prepared`, it has the same
    /// Clips at all steps together, with exact decisions. `regionOf` leaves it null for one
    /// axis-aligned rectangle, at which nothing else is faster.
    std::shared_ptr<const LaterRegion> prepared{};
    std::shared_ptr<const LaterRegion> opposite{}; ///< the same with the other side kept
    friend bool operator==(const ClipRegion& a, const ClipRegion& b)
    {
        return a.keep == b.keep && a.steps == b.steps;
    }

    /// Whether there is no window, so that nothing is cut.
    bool everything() const { return steps.empty(); }
    /// Whether the set starts with all points; otherwise with none.
    bool startsFull() const
    {
        return everything() || steps.front().operation != WindowOperation::Add;
    }
    /// The window if the set is one rectangle; `keep` may have either value.
    std::optional<clipping::Window> single() const;
};

/// The same windows with the other side kept, or the same one.
ClipRegion withKeep(ClipRegion region, Keep keep);

/// Marks, in `Clipped::cut`, an end at the border of a window that is not an axis-aligned
/// rectangle.
inline constexpr clipping::Edge borderEdge = clipping::Edge::Near;

/// The region of the windows that have an effect. Curves become inscribed polygons, no farther than
/// `tolerance` (user units, > 0) from them.
ClipRegion regionOf(const ClipWindows& windows, double tolerance);
/// The same of a drawing's windows with the usual tolerance, 0.01 mm on paper.
ClipRegion regionOf(const ClipWindows& windows, const Page& page);
/// For a screen: what lies on the border of a window of its own shape is in the window, as it is
/// when the drawing is cut. Curves have the chords that objects have, ellipses are polygons around
/// these.
ClipRegion shownRegionOf(const ClipWindows& windows, const Page& page);

/// What is kept of everything inside a box. Pieces: this depends on the lines themselves.
enum class Remains : std::uint8_t { Gone, Whole, Pieces };

/// Gone and Whole are never wrong: a line with both ends in the closed box is removed, or kept
/// whole. The result is Pieces for an inverted box and for a box with a number that is not finite,
/// unless nothing is cut.
Remains remainsOf(const ClipRegion& region, const clipping::Window& box);

/// Combines the pieces that an algorithm leaves of one line inside each step's window into the kept
/// pieces, and appends these in the line's order. `atStep` has one element for each step. Each end
/// is an end of the line or of a piece, bit for bit. `Clipped::cut` names the window edge that the
/// end lies on, or Edge::NoEdge for an end of the line. The edge's level is the coordinate of the
/// end across that edge. `source` is stored in every piece.
///
/// For one rectangle the result is the algorithm's piece, or its `outsideAll`, bit for bit. With
/// several windows, ends on the same level of an axis are merged into the first of them if they
/// differ by at most an algorithm's rounding (128 ulps of the largest coordinate), and so are ends
/// that differ by no more, if one is at the border of a rotated or polygonal window. So a line that
/// crosses an edge shared by two windows stays whole. A piece that is not finite is ignored; a
/// piece in reverse direction (from a published form) is turned round. The row `exact` is not
/// folded: the prepared region orders its cuts exactly.
void fold(const ClipRegion& region, const clipping::Segment& line, std::uint32_t source,
          std::span<const std::optional<clipping::Clipped>> atStep,
          std::vector<clipping::Clipped>& kept);

} // namespace app
