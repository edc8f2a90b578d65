// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/memory.h"
#include "app/document/affine_map.h"
#include "app/document/flatten.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// The outline of an object: immutable, packed subpaths. A copy shares the points. A single line or
/// point needs no heap block. A subpath of lines is a run of points (16 bytes each); a path with
/// curves has one more byte for each segment, and three points for each curve. Fewer than 2^31
/// points.
class Path {
public:
    /// The stored form: `points`, `sizes` and `kinds` are packed as `path_storage.h` describes.
    struct Parts {
        Placement placement{};
        std::span<const Point> points{};
        std::span<const std::uint32_t> sizes{};
        std::span<const std::uint8_t> kinds{};
    };

    Path() = default;                             ///< without subpaths
    explicit Path(const clipping::Segment& line); ///< a single point if a and b are the same bits
    explicit Path(std::span<const Subpath> subpaths);
    Path(const Path& other) noexcept;
    Path(Path&& other) noexcept;
    Path& operator=(Path other) noexcept;
    ~Path();

    std::vector<Subpath> subpaths() const; ///< in document coordinates
    /// The line or point (a == b) if the path is nothing else.
    std::optional<clipping::Segment> singleLine() const;
    std::size_t subpathCount() const;
    std::size_t pointCount() const; ///< the stored points with control points; 2 for a single line
    bool straight() const;          ///< whether it has no curves
    bool hasArea() const;           ///< whether a subpath has a curve or several lines
    HeapPart heapPart() const;      ///< the heap block of its points
    /// The stored form, for files that must restore later roundings as well. Empty for a single
    /// line or point, and without subpaths. The spans are valid as long as this path.
    std::optional<Parts> parts() const;
    /// The path of that stored form; empty if the parts do not fit together.
    static std::optional<Path> of(const Parts& parts);
    /// A path with the same stored points and another placement; not for single lines.
    Path withPlacement(const Placement& placement) const;

    /// The path moved by `where`: its points are transformed by its own placement and then by
    /// `where`. O(1). A single line is recalculated; it becomes a point if its ends then coincide.
    Path placed(const Placement& where) const;
    /// Calls visit(Point) for every point in order, including control points.
    template <class Visit>
    void forEachPoint(const Visit& visit) const
    {
        const Placement where = placement();
        for (const Point& p : stored())
            visit(where(p));
    }
    /// Compares the subpaths: transformed points must have the same bits (so -0 differs from 0, and
    /// a NaN equals itself), regardless of the placements.
    friend bool operator==(const Path& a, const Path& b);

    /// Appends the chords of all subpaths, with the same bits as `flatten(Subpath)`.
    friend void flatten(const Path& path, double tolerance, std::vector<Chord>& chords);
    /// Appends the chords of a path as segments.
    friend void appendSegments(const Path& path, double tolerance,
                               std::vector<clipping::Segment>& to);

private:
    struct Data; // the header of the heap block; points, subpath sizes and segment kinds follow it
    static Data* lineMark();
    Placement placement() const;
    std::span<const Point> stored() const;
    bool isLine() const { return data_ == lineMark(); }

    Data* data_ = nullptr;        // null: no subpath; lineMark(): the line in ends_
    std::array<Point, 2> ends_{}; // the ends of a line, or scale and offset for data_
};
static_assert(sizeof(Path) == 40);

void flatten(const Path& path, double tolerance, std::vector<Chord>& chords);
void appendSegments(const Path& path, double tolerance, std::vector<clipping::Segment>& to);

/// Calls `visit` for every point of a path: its start, the end of each path segment, and the
/// control points of curves. `visit` may change the points if the path is not const.
template <class SomePath, class Visit>
void forEachPoint(SomePath& path, const Visit& visit)
{
    visit(path.start);
    for (auto& segment : path.segments) {
        visit(segment.to);
        if (segment.curved) {
            visit(segment.control1);
            visit(segment.control2);
        }
    }
}

} // namespace app
