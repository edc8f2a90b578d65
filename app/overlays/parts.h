// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/overlays/overlay.h"

#include <array>

// The kinds of overlays, one file each. An algorithm's row (app/teaching/teaching.h) names its own
// overlay, or has the default. Each has an area or a line and a caption, and with a line also a
// mark at each of its ends, and another caption.

namespace app {

/// The input of an overlay: all numbers are finite, and the window has min <= max.
struct OverlayContext : OverlaySubject {
    clipping::Trace trace{}; ///< of the line, if any

    /// The trace of this variant for another line.
    clipping::Trace traceOf(const clipping::Segment& other) const
    {
        if (!corners.empty())
            return polygonUsesOf(variant)->trace(other, {corners});
        return functionsOf(variant).trace(other, window);
    }
};

Overlay outcodeOverlay(const OverlayContext& context);   ///< Cohen-Sutherland
Overlay scriptOverlay(const OverlayContext& context);    ///< Sobkow-Pospisil-Yang
Overlay midpointOverlay(const OverlayContext& context);  ///< Midpoint subdivision
Overlay signOverlay(const OverlayContext& context);      ///< Skala
Overlay sectorOverlay(const OverlayContext& context);    ///< Nicholl-Lee-Nicholl
Overlay parameterOverlay(const OverlayContext& context); ///< Liang-Barsky, Cyrus-Beck
Overlay pushOverlay(const OverlayContext& context);      ///< Kodituwakku…, Matthes-Drakopoulos
Overlay cellOverlay(const OverlayContext& context);      ///< Slater-Barsky
Overlay turnOverlay(const OverlayContext& context);      ///< Exact

/// The default overlay of any algorithm: the edges, and the points where its steps cut the line.
Overlay traceOverlay(const OverlayContext& context);

/// The overlay of any algorithm at a convex polygon.
Overlay polygonOverlay(const OverlayContext& context);

} // namespace app

// Parts that several overlays share.

namespace app {

inline constexpr std::array windowEdges{clipping::Edge::Left, clipping::Edge::Right,
                                        clipping::Edge::Bottom, clipping::Edge::Top};

/// The nine outcode regions, each with a name; the region under the pointer is marked.
std::vector<OverlayArea> regionsNamed(const OverlayContext& context,
                                      QString (*name)(unsigned code, YAxis y));
/// The same with outcodes (app/comparison/line_class.h) as names; set bits are emphasized.
std::vector<OverlayArea> outcodeRegions(const OverlayContext& context);
/// The borders of the regions: the lines of the window's edges.
std::vector<OverlayLine> regionBorders(const OverlayContext& context);

/// The two ends of the line, each with its name and an additional word.
std::vector<OverlayMark> endMarks(const clipping::Segment& line, const QString& ofA,
                                  const QString& ofB);

/// The outcode bit of an edge.
constexpr unsigned bitOf(clipping::Edge edge) { return 1U << (unsigned(edge) - 1); }
/// The outcodes of both ends.
struct CodePair {
    unsigned a, b;
};
CodePair codesOf(const OverlayContext& context);
/// Both ends' codes, AND and OR; the row that decides, if any, is highlighted.
OverlayTable codeTable(const OverlayContext& context);
/// The decision that the codes of both ends allow, in words.
QString codeWords(const OverlayContext& context);

/// The move of one end to an edge.
struct EndMove {
    bool ofB;
    clipping::Edge edge;
    Point from, to;
};
/// Every move of a trace, in order; a move in several steps is one move.
std::vector<EndMove> movesOf(const clipping::Trace& trace, const clipping::Segment& line);
/// The visible parts of the paths of moved ends.
std::vector<OverlayLine> moveLines(const OverlayContext& context, std::span<const EndMove> moves);
/// A mark with a number and the edge at the end of each move.
std::vector<OverlayMark> moveMarks(const OverlayContext& context, std::span<const EndMove> moves);

/// The visible part of an edge's infinite line; empty if it is not visible.
std::optional<OverlayLine> border(clipping::Edge edge, const OverlayContext& context);

/// "left", "top": as seen on screen.
QString edgeName(clipping::Edge edge, YAxis y);
/// "L", "T": as seen on screen.
QString edgeLetter(clipping::Edge edge, YAxis y);
/// "End 1", "End 2".
QString endName(bool ofB);
/// How to see more; for a caption.
QString pointAtALine();

} // namespace app
