// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"
#include "app/document/page.h"
#include "app/view/grid.h"
#include "app/view/snapping/alignment.h"
#include "clipping/geometry.h"

#include <QString>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace app {

struct SnapSurroundings;
class SnapOffers;

/// A better rank wins at any distance within the radius; within a rank the nearest place wins.
enum class SnapRank : std::uint8_t {
    Single, ///< a single point, such as an end
    Along,  ///< any point along something
    Grid    ///< counts only where nothing else is near
};

/// One kind of place that the pointer snaps to: a row of the catalogue.
struct SnapKind {
    std::string_view key;    ///< in the settings
    QString name;            ///< in the list of kinds
    QString word;            ///< at the pointer
    QString cornerWord = {}; ///< at the pointer, at a corner of an edge
    SnapRank rank = SnapRank::Single;
    bool usual = true; ///< on, until a person chooses
    /// The strokes of its glyph, in a square from -1 to 1, y down.
    std::span<const clipping::Segment> glyph = {};
    /// Offers the places near the pointer. Null: `Snapper` finds them.
    void (*find)(const SnapSurroundings&, SnapOffers&) = nullptr;
};

/// Every kind, in the order of the list of kinds. Of places at the same distance the first kind
/// wins.
std::span<const SnapKind> snapKinds();
/// A kind that exists.
const SnapKind& snapKind(std::string_view key);

/// What is near the pointer, for the kinds of places to snap to.
struct SnapSurroundings {
    Point pointer;
    double radius;                           ///< in user units
    std::optional<Point> from{};             ///< where the line that is being drawn begins
    std::vector<clipping::Segment> lines{};  ///< path segments that are lines, or single points
    std::vector<Bezier> curves{};            ///< path segments that are curves
    std::vector<clipping::Segment> chords{}; ///< all lines, and the chords of the curves
    std::vector<Point> centres{};
    std::vector<clipping::Segment> windowEdges{}; ///< of visible clip windows; none of curves
    std::vector<clipping::Segment> pageEdges{};
    std::vector<Guide> guides{};
    std::optional<GridPoints> grid{};
};

/// A place that the pointer snaps to.
struct Snap {
    Point point;
    const SnapKind* kind;
    bool corner = false;                ///< of an edge
    std::vector<AlignmentLine> lines{}; ///< what the point is aligned with

    const QString& word() const { return corner ? kind->cornerWord : kind->word; }
    friend bool operator==(const Snap&, const Snap&) = default;
};

/// Chooses among the places that the kinds offer: the one of the best rank, then the nearest; at
/// the same distance, apart from rounding, the one offered first. Places farther away than the
/// radius are ignored, and places that are not finite.
class SnapOffers {
public:
    SnapOffers(const Point& pointer, double radius) : pointer_(pointer), radius_(radius) {}

    void begin(const SnapKind& kind) { kind_ = &kind; } ///< of the next offers
    void add(const Point& place) { consider({place, kind_}, kind_->rank); }
    void addCorner(const Point& place) { consider({place, kind_, true}, SnapRank::Single); }

    const std::optional<Snap>& best() const { return best_; }
    SnapRank rank() const { return rank_; }       ///< of the best one, if any
    double distance() const { return distance_; } ///< of the best one, if any

private:
    void consider(const Snap& snap, SnapRank rank);

    Point pointer_;
    double radius_;
    const SnapKind* kind_ = nullptr;
    std::optional<Snap> best_;
    SnapRank rank_ = SnapRank::Grid;
    double distance_ = 0;
};

} // namespace app
