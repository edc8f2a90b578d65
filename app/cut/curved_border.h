// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/box_index.h"
#include "app/cut/true_curve.h"
#include "app/document/clip_windows.h"
#include "app/document/document.h"
#include "app/document/flatten.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <map>
#include <stop_token>

namespace app {

/// Where something meets a border.
struct BorderMeeting {
    Point point;
    double t; ///< of a curve that meets it
    const TrueCurve* border;
    double onBorder; ///< its parameter
};

/// The border of clip windows or areas with curves, and the drawing's curves that run along it.
///
/// They are cut at as polygons. A curve that coincides with a curved edge would cross its
/// polygon again and again, and end as dashes. So coincidence is found first: where a curve of the
/// drawing runs along the border (within `near`, and then up to twice that), or a line from end to
/// end, its chords are the polygon's own edges, bit for bit; what follows treats them as shared
/// edges. Curves that draw parts of ellipses count as these.
class CurvedBorder {
public:
    /// How far apart two curves may be that are the same, if `near` (user units) is not given.
    static constexpr double millimetres = 0.001;

    /// Whether polygons are borders, too: for drawings with curves, which may be along their sides.
    enum class Sides : std::uint8_t { No, Yes };
    static Sides sidesFor(const Objects& objects);

    CurvedBorder() = default; ///< empty
    /// Of the visible windows, as polygons within half of `near`, so that a curve further from one
    /// crosses its polygon only where it crosses the window. Empty if none has curves. Where
    /// borders of several are the same, all have the edges of the first.
    CurvedBorder(const ClipWindows& windows, const Page& page, double near = 0,
                 Sides sides = Sides::No);
    /// Of areas, as polygons within a tolerance (user units). Where borders of several are the
    /// same, curves have the edges of the first.
    CurvedBorder(std::span<const Path> areas, double tolerance, const Page& page, double near = 0);
    bool isEmpty() const { return edges_.empty(); }

    /// Divides the border where curves and lines of the drawing begin or end on it, so that what
    /// ends on it is not cut there; and where they pass so near beside it that its polygon would
    /// not tell whether they meet it (touching_border.cpp).
    void divideFor(const Objects& objects, double tolerance, const std::stop_token& stop = {});
    /// The border, divided where lines pass beside it; empty if it need not be.
    std::optional<CurvedBorder> dividedFor(std::span<const clipping::Segment> lines) const;
    /// The windows as polygons; of areas, flattenAlong() gives them.
    ClipWindows polygons() const;

    /// A segment of a path, which is a curve, as it counts: also as a part of an ellipse that the
    /// border has.
    TrueCurve curveAt(const Subpath& path, std::size_t segment) const;
    /// Appends the chords of a path as `flatten` does, of its true curves, along the border where
    /// the path is.
    void flattenAlong(const Path& path, double tolerance, std::vector<Chord>& chords) const;

    /// Where a line that is cut at a point of the polygons meets the border itself; its own end if
    /// that is between the curve and its chord. Empty: the point is not on a curved edge.
    std::optional<BorderMeeting> meeting(const clipping::Segment& line, const Point& cut) const;
    /// Where the curve of a chord that is cut there meets it.
    std::optional<BorderMeeting> meeting(const TrueCurve& curve, const Chord& chord,
                                         const Point& cut) const;
    /// Whether a piece is so short that it is on the border, where that is only known to be so
    /// near.
    bool isNothing(const Subpath& piece) const;
    /// The part of the border's curve whose chord this edge of the polygons is. Empty: the border
    /// is straight there.
    std::optional<CurvePart> partAlong(const clipping::Segment& edge) const;

private:
    /// An edge of a window's polygon: a chord of its curve, or straight. There are very many.
    struct Edge {
        Point from;
        double t0 = 0, t1 = 0;           ///< the part of the curve
        std::uint32_t source = straight; ///< of sources_
        bool isEnd = false; ///< whether something of the drawing or a window ends where it begins

        /// Neither is of sources_. Curves may run along a side of a polygon.
        static constexpr std::uint32_t straight = 0xffffffff, side = 0xfffffffe;
        bool isCurved() const { return source < side; }
        bool isStraight() const { return source == straight; }
    };
    struct Ring {
        std::size_t window;
        std::vector<Edge> edges{};
    };
    /// An edge along a curve's part [low, high].
    struct Shared {
        double low, high;
        Point atLow, atHigh;
        int near = 0, same = 0; ///< so many of `places` are within `near_`, and nearlySame()
        bool isTouch = false;   ///< only of curves that touch, or cross at a small angle
    };
    static constexpr int places = 9; ///< of an edge that are looked at, its ends among them
    /// An edge along which curves may run, by the numbers of its ring and of it there.
    struct Place {
        std::size_t ring, edge;
    };

    void flattenTruly(const Subpath& path, double tolerance, std::vector<Chord>& chords) const;
    void divideAtEndsOfWindows();
    void divideWhereWindowsCross();
    void findEllipses(std::span<const Path* const> borders);
    void add(const PathShape& shape, std::size_t window);
    void add(const Subpath& path, std::size_t window);
    void makeIndex();
    /// The box so far around a chord.
    static clipping::Window around(const clipping::Segment& chord, double by)
    {
        return {glm::min(chord.a, chord.b) - by, glm::max(chord.a, chord.b) + by};
    }
    /// Whether two points are the same but for rounding: usually, a nanometre on paper.
    bool areSame(const Point& p, const Point& q) const
    {
        return glm::distance(p, q) <= near_ / 1000;
    }
    /// Whether two curves are parts of one ellipse.
    bool areSame(const std::optional<EllipseArc>& a, const std::optional<EllipseArc>& b) const;
    const Edge& edgeAt(const Place& place) const { return rings_[place.ring].edges[place.edge]; }
    CurvePart partOf(const Place& place) const;
    std::optional<Place> edgeThrough(const Point& cut) const;
    Place after(const Place& place) const
    {
        return {place.ring, (place.edge + 1) % rings_[place.ring].edges.size()};
    }
    const Point& endOf(const Place& place) const { return edgeAt(after(place)).from; }
    std::vector<Subpath> alongOthers(const Path& border) const;
    /// What of the drawing ends on the border. A line's end leaves the sides of polygons as they
    /// are, bit for bit; a curve's end divides them.
    enum class Ending : std::uint8_t { Line, Curve };
    struct Cut {
        Point at;
        Ending ending;
    };
    struct Cuts {
        std::map<std::uint32_t, std::vector<Cut>> on; ///< edges, by their numbers
        bool moved = false;                           ///< a corner is elsewhere now
    };
    void divideAtEndsOf(const Path& path, Cuts& cuts);
    void addSides();
    void addCrossings(std::uint32_t edge, Cuts& cuts) const;
    /// Adds the ends that a curve's chord needs beside straight edges of windows.
    void addSidesBeside(const TrueCurve& curve, const Chord& chord, double tolerance,
                        std::vector<CurvePoint>& ends) const;
    void addTouchesOf(const ObjectView& object, double tolerance, Cuts& cuts) const;
    void addTouches(const clipping::Segment& line, Cuts& cuts) const;
    void addTouches(const TrueCurve& curve, const CurvePoint& from, const CurvePoint& to,
                    std::uint32_t edge, Cuts& cuts) const;
    struct Gap {
        double u, distance;
        double turn; ///< from the curve's direction to the border's; 0 where they are parallel
    };
    static Gap gapAt(const TrueCurve& curve, double t, const TrueCurve& border, const Edge& edge);
    std::uint32_t numberOf(std::uint32_t source, double t) const; ///< of the edge there
    /// Whether polygons are so near to the border that its curves may count where they touch the
    /// drawing's: for windows. Thousands of areas would take too long.
    bool isFine() const { return tolerance_ <= near_; }
    /// How far a chord may be from a point that it cuts off its curve, or the border's.
    double touchesNear() const { return 1.5 * tolerance_; }
    void divideAt(const Point& p, Ending ending, Cuts& cuts);
    /// Places on an edge's curve between the ends of its chord.
    std::array<Point, 7> between(const Place& place) const;
    const TrueCurve& sourceOf(const Edge& edge) const { return sources_[edge.source]; }
    bool mayMoveEnd(const Place& place, const Point& p) const;
    void moveEnd(const Place& place, const Point& p);
    struct Where {
        double share; ///< of the way from a to b
        double distance;
    };
    static Where placeOn(const Point& a, const Point& b, const Point& p);
    struct Corner {
        double t;     ///< of the edge's curve; of a side, its share
        Point at, on; ///< and the nearest point of the curve
        Ending ending = Ending::Curve;
    };
    Corner cornerOn(const Place& place, const Point& p) const;
    std::vector<Edge> divided(const Place& place, std::span<const Cut> cuts) const;
    void divide(const Cuts& cuts);
    /// An edge that begins beside a curve, and where that is on the curve.
    struct Near {
        std::uint32_t edge;
        double t, distance;
    };
    /// The edge of one of those beside the curve.
    std::optional<Shared> shared(const Near& from, std::span<const Near> all,
                                 const TrueCurve& curve) const;
    std::optional<double> parameterAtEnd(const Place& place, std::span<const Near> all) const;
    bool isOf(const Edge& edge, const TrueCurve& curve) const
    {
        return edge.isCurved() && sourceOf(edge) == curve;
    }
    struct Beside {
        std::vector<Near> edges;
        /// Of the curve's chords, which are short beside them; also where it passes their corners.
        std::vector<CurvePoint> ends;
    };
    /// A curve of a path at the border.
    struct Along {
        TrueCurve curve;
        std::span<const Chord> plain; ///< its chords elsewhere
        Beside near;
        std::vector<Shared> shared; ///< in order, none over another
    };
    /// For each segment of a path, with its chords, whether it is a curve.
    std::vector<std::optional<Along>> along(const Subpath& path, std::span<const Chord> plain,
                                            double tolerance) const;
    class Runs;
    bool turnsAt(const Point& p) const;
    void flattenAlong(const Subpath& path, std::span<const Chord> plain, double tolerance,
                      std::vector<Chord>& chords) const;
    void flattenAlong(const Along& along, Point& at, std::vector<Chord>& chords) const;
    void addCorners(const TrueCurve& curve, Beside& near) const;
    /// `plain` are chords within the tolerance of it.
    Beside beside(const TrueCurve& curve, std::span<const Chord> plain, double tolerance) const;
    /// Who is within `near_` of a border runs along it as long as it is within this, so that two
    /// curves that are as far apart are not divided again and again.
    double stillNear() const { return 2 * near_; }
    /// Nearer than curves are for long that touch each other.
    double nearlySame() const { return near_ / 50; }
    /// Calls visit(number) for the edges that begin at a point.
    template <class Visit>
    void forEdgesFrom(const Point& p, const Visit& visit) const
    {
        const double rounding = near_ / 1000;
        starts_.meeting({p - rounding, p + rounding}, 0, [&](std::uint32_t edge) {
            if (areSame(edgeAt(edges_[edge]).from, p))
                visit(edge);
        });
    }
    bool isEdge(const Point& from, const Point& to) const;
    /// Whether chords, or a path, may be beside the border or a straight edge of a window.
    bool isBeside(std::span<const Chord> chords, double tolerance) const;
    bool isBeside(const Path& path) const;
    bool isBeside(const clipping::Window& box) const;
    bool isBesideCorner(const Point& p, const Point& corner) const;
    std::vector<Point> cornersAlong(const clipping::Segment& line, Place place) const;
    /// The chords of a line along the border, up to both ends; empty: it is not along it.
    std::vector<Chord> linesAlong(const Chord& chord) const;
    /// Adds the edges along the curve, only its own ones or only others, beside those there are.
    void addShared(Along& along, bool own) const;

    ClipWindows windows_;
    std::vector<std::size_t> withRings_; ///< the numbers of windows with rings
    double tolerance_ = 0, near_ = 0;    ///< in user units
    std::vector<EllipseArc> ellipses_;   ///< that the border certainly has
    BoxIndex ellipsesAt_;
    std::vector<TrueCurve> sources_;
    std::vector<Ring> rings_;
    std::vector<Place> edges_;             ///< along which curves may run
    BoxIndex index_;                       ///< of these
    BoxIndex starts_;                      ///< of their first points
    BoxIndex curves_;                      ///< of the sources
    std::vector<clipping::Segment> sides_; ///< straight edges of windows, if there are curves
    BoxIndex sidesAt_;
    /// The edges of each source, which follow each other.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesOf_;
};

} // namespace app
