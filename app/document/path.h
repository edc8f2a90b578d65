// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/heap_bytes.h"
#include "app/document/flatten.h"
#include "app/document/placement.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// The outline of an object: subpaths, packed and never changed. Copying it copies no points. A
/// single line or point has no heap block of its own. Lines are runs of points (16 bytes each); a
/// path with curves has a byte a segment more, and three points a curve. Fewer than 2^31 points.
class Path {
public:
    Path() = default;                             ///< no subpath
    explicit Path(const clipping::Segment& line); ///< a and b of the same bits: a single point
    explicit Path(std::span<const Subpath> subpaths);
    Path(const Path& other) noexcept;
    Path(Path&& other) noexcept;
    Path& operator=(Path other) noexcept;
    ~Path();

    std::vector<Subpath> subpaths() const; ///< in document coordinates
    /// The line or the point (a == b) that it is, if it is nothing else.
    std::optional<clipping::Segment> singleLine() const;
    std::size_t subpathCount() const;
    std::size_t pointCount() const; ///< those that are stored, controls too; 2 for a single line
    bool straight() const;          ///< without curves
    bool hasArea() const;           ///< more than a line or a point: something to fill
    HeapPart heapPart() const;      ///< where its points are

    /// The path at another place: its points through its own placement and then `where`. O(1), but
    /// for a single line, whose ends are calculated (one whose ends then coincide is a point).
    Path placed(const Placement& where) const;
    /// Calls visit(Point) for every point, controls included, in order.
    template <class Visit>
    void forEachPoint(const Visit& visit) const
    {
        const Placement where = placement();
        for (const Point& p : stored())
            visit(where(p));
    }
    /// The same subpaths: their points have the same bits where they lie (so -0 is not 0, and a NaN
    /// is itself), whatever the placements.
    friend bool operator==(const Path& a, const Path& b);

    /// What `flatten` makes of each subpath, one after the other; the same bits.
    friend void flatten(const Path& path, double tolerance, std::vector<Chord>& chords);
    /// The chords of a path as segments.
    friend void appendSegments(const Path& path, double tolerance,
                               std::vector<clipping::Segment>& to);

private:
    struct Data; // its head; the points, the sizes of the subpaths and the kinds of segments follow
    static Data* lineMark();
    Placement placement() const;
    std::span<const Point> stored() const;
    bool isLine() const { return data_ == lineMark(); }

    Data* data_ = nullptr;        // null: no subpath; lineMark(): the line in ends_
    std::array<Point, 2> ends_{}; // a line's ends, or scale and offset of data_
};
static_assert(sizeof(Path) == 40);

void flatten(const Path& path, double tolerance, std::vector<Chord>& chords);
void appendSegments(const Path& path, double tolerance, std::vector<clipping::Segment>& to);

} // namespace app
