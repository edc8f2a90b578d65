// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/family.h"

#include <array>

// What several families show.

namespace app {

inline constexpr std::array windowEdges{clipping::Edge::Left, clipping::Edge::Right,
                                        clipping::Edge::Bottom, clipping::Edge::Top};

/// The nine regions that outcodes tell apart, each with a name; the pointer's is pointed at.
std::vector<OverlayArea> regionsNamed(const Seeing& seeing,
                                      QString (*name)(unsigned code, YAxis y));
/// Each with its outcode (app/comparison/outcode_text.h), whose set bits stand out.
std::vector<OverlayArea> outcodeRegions(const Seeing& seeing);
/// The borders of the regions: the lines of the window's edges.
std::vector<OverlayLine> regionBorders(const Seeing& seeing);

/// The two ends of the line, each with its name and a word more.
std::vector<OverlayMark> endMarks(const clipping::Segment& line, const QString& ofA,
                                  const QString& ofB);

/// The bit of an outcode that says: beyond this edge.
constexpr unsigned bitOf(clipping::Edge edge) { return 1U << (unsigned(edge) - 1); }
/// Outcodes of both ends.
struct CodePair {
    unsigned a, b;
};
CodePair codesOf(const Seeing& seeing);
/// Both ends' codes, AND and OR; lit is the row that decides, if one does.
OverlayTable codeTable(const Seeing& seeing);
/// What the codes of both ends decide, in words.
QString codeWords(const Seeing& seeing);

/// One end was moved to an edge.
struct EndMove {
    bool ofB;
    clipping::Edge edge;
    Point from, to;
};
/// Every move of a trace, in order; what is done in several steps is one.
std::vector<EndMove> movesOf(const clipping::Trace& trace, const clipping::Segment& line);
/// The ways that ends were moved, as far as they are seen.
std::vector<OverlayLine> moveLines(const Seeing& seeing, std::span<const EndMove> moves);
/// A mark with a number and the edge at the end of each.
std::vector<OverlayMark> moveMarks(const Seeing& seeing, std::span<const EndMove> moves);

/// The infinite line of an edge, as far as it is seen; nothing: it is not.
std::optional<OverlayLine> border(clipping::Edge edge, const Seeing& seeing);

/// "left", "top": as it is seen.
QString edgeName(clipping::Edge edge, YAxis y);
/// "L", "T": as it is seen.
QString edgeLetter(clipping::Edge edge, YAxis y);
/// "End 1", "End 2".
QString endName(bool ofB);
/// What to do to see more; for a caption.
QString pointAtALine();

} // namespace app
