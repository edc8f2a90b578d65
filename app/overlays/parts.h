// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/family.h"

#include <array>

// Parts that several overlays share.

namespace app {

inline constexpr std::array windowEdges{clipping::Edge::Left, clipping::Edge::Right,
                                        clipping::Edge::Bottom, clipping::Edge::Top};

/// The nine outcode regions, each with a name; the region under the pointer is marked.
std::vector<OverlayArea> regionsNamed(const OverlayContext& context,
                                      QString (*name)(unsigned code, YAxis y));
/// The same with outcodes (app/comparison/outcode_text.h) as names; set bits are emphasized.
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
