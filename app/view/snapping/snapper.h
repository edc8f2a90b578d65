// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picking.h"
#include "app/view/snapping/centre_index.h"
#include "app/view/snapping/own_points.h"
#include "app/view/snapping/snap_offers.h"
#include "app/view/snapping/snap_to.h"

namespace app {

/// What is asked of a Snapper.
struct SnapQuery {
    Point pointer;
    double radius; ///< in user units
    SnapTo to = SnapTo::All;
    std::optional<Point> from{}; ///< where the line that is being drawn begins
    ObjectRanges without{};      ///< objects that are not snapped to, except for `parts`
    /// The number of a clip window that is not snapped to: the one that is dragged.
    std::optional<std::size_t> withoutWindow{};
    /// The part of the drawing that is seen: its objects are aligned with. Empty: with none.
    std::optional<clipping::Window> seen{};
    std::optional<GridPoints> grid{}; ///< the grid, if it is shown
    const Guides* guides = nullptr;   ///< those of the page, if they are shown
    NearLimits limits{600, 150'000};
    /// Single segments and points of objects in `without`; null: none.
    const std::vector<Subpath>* parts = nullptr;
};

/// How something is moved as a whole, after snapping.
struct MovedSnap {
    Point by;
    std::optional<Snap> place{};        ///< that one of its own points snaps to
    std::vector<AlignmentLine> lines{}; ///< what its bounds are aligned with
};

/// Finds the place in a drawing that the pointer snaps to. The time is bounded whatever is under
/// the pointer: at most 600 lines count, the nearest ones (Picking::near), and of those with
/// curves objects of together 20,000 points and 200 curves; the nearest 100 lines are intersected.
class Snapper {
public:
    Snapper(const EditedDocument& document, const Scene& scene, const Picking& picking)
        : document_(document), scene_(scene), picking_(picking), centres_(document, scene)
    {
    }

    /// The place for the pointer. Where no place is near, it is aligned with the boxes of objects.
    std::optional<Snap> at(const SnapQuery& query) const;

    /// The place for a thing that is moved by `by`: that of its own point which has the best place,
    /// within the radius, or else the edges and middles with which its own are aligned. The query's
    /// pointer does not count.
    MovedSnap moved(const OwnPoints& own, const Point& by, SnapQuery query) const;

private:
    SnapSurroundings around(const SnapQuery& query) const;
    SnapOffers offers(const SnapQuery& query) const;
    Alignment aligned(const clipping::Window& box, const SnapQuery& query) const;
    std::vector<clipping::Window> boxesAround(const Point& centre, const SnapQuery& query) const;
    void addLines(const SnapQuery& query, SnapSurroundings& near) const;
    static void addParts(const SnapQuery& query, SnapSurroundings& near);

    const EditedDocument& document_;
    const Scene& scene_;
    const Picking& picking_;
    CentreIndex centres_;
};

/// The nearest place on a window's edges, or a corner.
std::optional<Snap> snapToEdges(const Point& pointer, double radius,
                                const clipping::Window& window);

} // namespace app
