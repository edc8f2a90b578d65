// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/trace.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace CLEARCUT_API clipping {

/// The functions of one form of an algorithm, for segments S and windows W.
///
/// `corrected` keeps this contract, for every row of the catalogue:
/// 1. For finite input and `min <= max` it returns the part of the segment inside the closed
///    window, directed from a to b; a single common point is a zero-length segment. It returns
///    nothing if there is no common point, if `min > max`, or if any number is not finite.
/// 2. It always ends, and returns no NaN, no infinity and no point outside the window (bitwise).
///    An end that is inside is returned bit for bit.
/// 3. Visibility can be wrong only where the exact clearance is at most k ulps of the largest
///    |coordinate| of segment and window; ends are off by at most k such ulps. k is the row's
///    `ulps`, derived in the algorithm's file, at most 64. Within k ulps a contact may become a
///    short segment, possibly in the wrong direction; only `exact` returns every contact as a
///    point.
///
/// `published` is what the authors printed, including its faults, and is exempt from 1 to 3. Its
/// iterations are capped: at the cap nothing is visible and the trace says DidNotEnd.
///
/// Lines and rays keep the same contract, with the two points that define them counted among the
/// coordinates; the visible part of a line or ray is a segment.
template <class S, class W, class Piece = S>
struct CLEARCUT_HOLDS_CONTAINERS Functions {
    /// The part of one segment inside the window; nothing if there is none.
    std::optional<Piece> (*clip)(const S& segment, const W& window);

    /// Clips many segments into the caller's buffer: `out.size() >= in.size()`, no overlap.
    /// Writes the visible pieces in input order and returns their number. Allocates nothing,
    /// except once per call for preparing a polygon.
    std::size_t (*clipAll)(std::span<const S> in, const W& window,
                           std::span<BasicClipped<Piece>> out);

    /// The number of operations needed to clip these segments. Like `trace`, it first sets this
    /// thread's `operations` (counted.h) to zero.
    OperationCounts (*count)(std::span<const S> in, const W& window);

    /// How one segment is clipped, step by step.
    BasicTrace<Piece::dimensions> (*trace)(const S& segment, const W& window);
};

/// k of the contract for convex polygons, for every row that supports them (polygon/README.md).
/// M is the largest |coordinate| of segment and polygon; "moved" edges are edges whose lines are
/// moved by k ulps of M on each axis.
/// 1. For finite input it returns the part of the segment inside the closed polygon, directed from
///    a to b. A single common point is a zero-length segment. geometry.h defines the inside of a
///    polygon. It returns nothing if any number is not finite.
/// 2. It always ends, and returns no NaN, no infinity and no point outside the polygon's bounding
///    box (bitwise), hence no point beyond a horizontal or vertical edge. An end that is inside is
///    returned bit for bit. A point on a slanted edge is usually not representable: a new end is
///    within k ulps of M, on each axis, of a point of the segment, and inside the polygon with all
///    its edges moved out.
/// 3. It returns what is inside the polygon with all its edges moved in, except for k ulps of M at
///    the ends. `cyrus-beck` may decide visibility wrongly only where moving the edges out or in
///    changes it; `skala` and `exact` never do. `exact` rounds each new coordinate once.
/// A polygon is prepared once per call (O(corners), the only allocation), so prefer clipAll.
inline constexpr double polygonUlps = 32;

/// k of the contract in three dimensions, for every row that supports boxes (box/README.md).
inline constexpr double boxUlps = 48;

/// The two forms of an algorithm: with its published defects corrected, and as its authors printed
/// it.
enum class Form : std::uint8_t { Corrected, Published };

/// One row of the catalogue. A null pointer means that there is no such form; `floats` is never
/// null.
struct CLEARCUT_HOLDS_CONTAINERS Algorithm {
    std::string_view key;                 ///< in files and on the command line; never changes
    std::string_view abbreviation;        ///< CS, LB ... EX, in any case
    std::string_view name;                ///< its authors' names, for display
    int year;                             ///< of its first publication
    std::string_view idea;                ///< one sentence
    double ulps;                          ///< k of the contract
    Functions<Segment, Window> corrected; ///< the form to use: keeps the contract
    const Functions<Segment, Window>* published;                      ///< as its authors printed it
    const Functions<BasicSegment<float>, BasicWindow<float>>* floats; ///< corrected, for floats
    const Functions<Segment, ConvexPolygon>* polygon;                 ///< clips at a convex polygon
    /// Same result, bit for bit, in O(log corners).
    const Functions<Segment, ConvexPolygon>* polygonBySearch;
    const Functions<Segment3, Window3>*
        box; ///< in three dimensions; keeps the contract with `boxUlps`
    const Functions<Line, Window, Segment>* line; ///< infinite lines; keeps the contract
    const Functions<Ray, Window, Segment>* ray;   ///< rays; keeps the contract
    /// The pseudo-code of each form, with the labels that a trace's steps name (pseudo_code.h);
    /// empty if there is none.
    std::string_view correctedCode;
    std::string_view publishedCode; ///< of the published form
};

/// The functions of one form of a row; null if there is no such form.
constexpr const Functions<Segment, Window>* functionsOf(const Algorithm& algorithm,
                                                        Form form) noexcept
{
    return form == Form::Corrected ? &algorithm.corrected : algorithm.published;
}

/// The pseudo-code of one form; empty if there is none.
constexpr std::string_view codeOf(const Algorithm& algorithm, Form form) noexcept
{
    return form == Form::Corrected ? algorithm.correctedCode : algorithm.publishedCode;
}

/// Every algorithm, in the order of every menu, table and chart.
std::span<const Algorithm> algorithms() noexcept;

/// The row `exact`: it makes no wrong decision and is the fastest on many segments. Use it if you
/// only want to clip.
const Algorithm& exactAlgorithm() noexcept;

/// The algorithm with that key or abbreviation (any case), or null.
const Algorithm* findAlgorithm(std::string_view keyOrAbbreviation) noexcept;

} // namespace clipping
