// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/trace.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace clipping {

/// What can be done with one form of an algorithm on segments S and windows W.
///
/// `corrected` keeps this contract, for every row of the catalogue:
/// 1. For finite input and `min <= max` it returns the part of the segment inside the closed
///    window, from a's side to b's side; a single common point is a zero-length segment.
///    Otherwise nothing. `min > max` or a number that is not finite, anywhere: nothing.
/// 2. It always ends; never NaN, never infinite, never a point outside the window (bitwise).
///    An end that was inside comes back bit for bit.
/// 3. A wrong visibility is possible only where the exact clearance is at most k ulps of the
///    largest |coordinate| of segment and window; ends are off by at most k of them. k is the
///    row's `ulps`, derived in the algorithm's file, at most 64. Within them a contact may have a
///    length, and so short a piece the wrong direction; only `exact` makes every contact a point.
///
/// `published` is what the authors printed, faults included, and is exempt from 1 to 3, but its
/// iterations are capped: then nothing is visible and the trace says DidNotEnd.
///
/// Lines and rays keep the same contract, where M counts the two points that they are given by;
/// what is left of them is a segment.
template <class S, class W, class Piece = S>
struct Uses {
    /// The part of one segment inside the window; nothing if there is none.
    std::optional<Piece> (*clip)(const S& segment, const W& window);

    /// Clips many into the caller's buffer: `out.size() >= in.size()`, no overlap. Keeps the
    /// order, drops the invisible, returns how many were written. Allocates nothing, but what
    /// a polygon is prepared with, once a call.
    std::size_t (*clipAll)(std::span<const S> in, const W& window,
                           std::span<BasicClipped<Piece>> out);

    /// The arithmetic that clipping these segments takes. Like `trace`, it begins by setting
    /// `operations` (counted.h) of this thread to zero.
    OperationCounts (*count)(std::span<const S> in, const W& window);

    /// How one segment is clipped, step by step.
    BasicTrace<Piece::dimensions> (*trace)(const S& segment, const W& window);
};

/// k of the contract against convex polygons, for every row that has them (README.md, "Polygons").
/// With M the largest |coordinate| of segment and polygon, and "moved" meaning each edge's line, by
/// k ulps of M on each axis:
/// 1. For finite input it returns the part of the segment inside the closed polygon, from a's side
///    to b's side. A single common point is a zero-length segment. What geometry.h says of a
///    polygon decides what that is; non-finite numbers anywhere: nothing.
/// 2. It always ends; never NaN, never infinite, never a point outside the polygon's bounding box
///    (bitwise), so never one beyond an edge that is horizontal or vertical. An end that was inside
///    comes back bit for bit. A point on a slanted edge is mostly not representable: a new end is
///    within k ulps of M, on each axis, of a point of the segment, and inside the polygon after all
///    its edges have moved out.
/// 3. What is inside the polygon after all its edges have moved in is returned, but for k ulps of M
///    at its ends. `cyrus-beck` may decide wrongly about visibility only where moving the edges,
///    out or in, changes it; `skala` never.
/// Polygons are looked at once a call (O(corners), the only allocation), so prefer clipAll.
inline constexpr double polygonUlps = 32;

/// k of the contract for the forms in three dimensions, of every row that has one (README.md,
/// "Boxes").
inline constexpr double boxUlps = 48;

/// The two forms of an algorithm: with its published defects corrected, and as its authors printed it.
enum class Form : std::uint8_t { Corrected, Published };

/// One row of the catalogue. A null pointer: there is no such form (`single` is never null).
struct Algorithm {
    std::string_view key;                   ///< in files and on the command line; never changes
    std::string_view abbreviation;          ///< CS, LB ... EX, in any case
    std::string_view name;                  ///< its authors' names, for people
    int year;                               ///< of its first publication
    std::string_view idea;                  ///< one sentence
    double ulps;                            ///< k of the contract
    Uses<Segment, Window> corrected;        ///< the form to use: keeps the contract
    const Uses<Segment, Window>* published; ///< as its authors printed it
    const Uses<BasicSegment<float>, BasicWindow<float>>* single; ///< corrected, for float data
    const Uses<Segment, ConvexPolygon>* polygon;         ///< a window that is a convex polygon
    const Uses<Segment, ConvexPolygon>* searchedPolygon; ///< the same bits, in O(log corners)
    const Uses<Segment3, Window3>* box; ///< in three dimensions; keeps the contract with `boxUlps`
    const Uses<Line, Window, Segment>* line; ///< infinite lines; keeps the contract
    const Uses<Ray, Window, Segment>* ray;   ///< rays; keeps the contract
    /// The pseudo-code of each form, for people: a line each, without numbers, from line 1 of a
    /// trace's steps on; empty where there is none.
    std::string_view correctedCode, publishedCode;
};

/// What a row does in one form; null if there is no such form.
constexpr const Uses<Segment, Window>* usesOf(const Algorithm& algorithm, Form form)
{
    return form == Form::Corrected ? &algorithm.corrected : algorithm.published;
}

/// The pseudo-code of one form; empty if there is none.
constexpr std::string_view codeOf(const Algorithm& algorithm, Form form)
{
    return form == Form::Corrected ? algorithm.correctedCode : algorithm.publishedCode;
}

/// Every algorithm, in the order of every menu, table and chart.
std::span<const Algorithm> algorithms();

/// The row `exact`: no wrong decision, and the fastest on many segments. Use it if you only clip.
const Algorithm& exactAlgorithm();

/// The algorithm with that key or abbreviation (any case), or null.
const Algorithm* findAlgorithm(std::string_view keyOrAbbreviation);

} // namespace clipping
