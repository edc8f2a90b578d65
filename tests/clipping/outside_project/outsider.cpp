// SPDX-License-Identifier: MIT
//
// A program of an outsider that uses everything that the library's headers have offered since its
// first version. It is never edited: that it compiles and runs unchanged is the promise to
// outsiders.
#include "clipping/algorithm.h"
#include "clipping/chunks.h"
#include "clipping/outside.h"
#include "clipping/polyline.h"

#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

namespace {

constexpr std::array<std::string_view, 11> keys{"cohen-sutherland",
                                                "liang-barsky",
                                                "cyrus-beck",
                                                "nicholl-lee-nicholl",
                                                "skala",
                                                "kodituwakku-wijeweera-chamikara",
                                                "matthes-drakopoulos",
                                                "midpoint-subdivision",
                                                "slater-barsky",
                                                "sobkow-pospisil-yang",
                                                "exact"};

int faults = 0;

void expect(bool holds, std::string_view row, const char* what)
{
    if (!holds)
        ++faults, std::fprintf(stderr, "%.*s: %s\n", int(row.size()), row.data(), what);
}

/// What one form of a row does, by all four functions.
template <class S, class W, class Piece>
void tryUses(const clipping::Functions<S, W, Piece>& uses, std::string_view row, const S& crossing,
             const S& missing, const W& window, const Piece& visible)
{
    const auto piece = uses.clip(crossing, window);
    expect(piece && piece->a == visible.a && piece->b == visible.b, row, "clip");
    expect(!uses.clip(missing, window), row, "clip of a miss");

    const std::vector<S> in{missing, crossing};
    std::vector<clipping::BasicClipped<Piece>> out(in.size());
    out.resize(uses.clipAll(in, window, out));
    expect(out.size() == 1 && out[0].source == 1 && out[0].cut != 0 && out[0].segment.a == visible.a
               && out[0].segment.b == visible.b,
           row, "clipAll");

    const clipping::OperationCounts counts = uses.count(in, window);
    expect(counts.comparisons + counts.additions + counts.multiplications + counts.divisions
                   + counts.negations
               > 0,
           row, "count");

    const auto trace = uses.trace(crossing, window);
    expect(trace.outcome == clipping::Outcome::Visible && !trace.steps.empty()
               && trace.visible.a == decltype(trace.visible.a)(visible.a),
           row, "trace");
    const auto& step = trace.steps.front();
    expect(!step.label.empty() && step.edge <= clipping::Edge::Far, row, "the first step");
    expect(uses.trace(missing, window).outcome == clipping::Outcome::Invisible, row,
           "trace of a miss");
}

void tryRow(const clipping::Algorithm& row)
{
    const clipping::Window window{.min = {-1, -1}, .max = {1, 1}};
    const clipping::Segment crossing{.a = {-2, 0}, .b = {2, 0}};
    const clipping::Segment missing{{5, 5}, {6, 6}};
    const clipping::Segment visible{{-1, 0}, {1, 0}};
    tryUses(row.corrected, row.key, crossing, missing, window, visible);
    if (row.published) {
        const auto piece = row.published->clip(crossing, window);
        expect(piece.has_value(), row.key, "published");
        expect(clipping::functionsOf(row, clipping::Form::Published) == row.published, row.key,
               "functionsOf");
    }
    expect(clipping::functionsOf(row, clipping::Form::Corrected) == &row.corrected, row.key,
           "functionsOf");

    using Single = clipping::BasicSegment<float>;
    tryUses(*row.floats, row.key, Single{{-2, 0}, {2, 0}}, Single{{5, 5}, {6, 6}},
            clipping::BasicWindow<float>{{-1, -1}, {1, 1}}, Single{{-1, 0}, {1, 0}});
    const clipping::ConvexPolygon square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (const auto* uses : {row.polygon, row.polygonBySearch})
        if (uses)
            tryUses(*uses, row.key, crossing, missing, square, visible);
    if (row.box)
        tryUses(*row.box, row.key, clipping::Segment3{{-2, 0, 0}, {2, 0, 0}},
                clipping::Segment3{{5, 5, 5}, {6, 6, 6}},
                clipping::Window3{{-1, -1, -1}, {1, 1, 1}},
                clipping::Segment3{{-1, 0, 0}, {1, 0, 0}});
    if (row.line)
        tryUses(*row.line, row.key, clipping::Line{{-3, 0}, {-2, 0}},
                clipping::Line{{0, 5}, {1, 5}}, window, visible);
    if (row.ray)
        tryUses(*row.ray, row.key, clipping::Ray{{-3, 0}, {-2, 0}}, clipping::Ray{{2, 0}, {3, 0}},
                window, visible);
}

void tryTheRest()
{
    const clipping::Window window{{-1, -1}, {1, 1}};
    const std::vector<clipping::Segment> lines{
        {{-2, 0}, {2, 0}}, {{5, 5}, {6, 6}}, {{0, 0}, {1, 0}}};
    const auto& exact = clipping::exactAlgorithm();
    std::vector<clipping::Clipped> inside(lines.size());
    inside.resize(exact.corrected.clipAll(lines, window, inside));
    expect(inside.size() == 2, exact.key, "clipAll of three lines");
    expect(clipping::cutEdgeOfA(inside[0].cut) == clipping::Edge::Left
               && clipping::cutEdgeOfB(inside[0].cut) == clipping::Edge::Right
               && inside[0].cut == clipping::cutAt(clipping::Edge::Left, clipping::Edge::Right),
           exact.key, "the edges of a cut");
    expect(inside[1].cut == 0 && inside[1].source == 2, exact.key, "a line that is not cut");
    std::vector<clipping::Clipped> outside(lines.size() + inside.size());
    outside.resize(clipping::outsideAll(lines, inside, outside));
    expect(outside.size() == 3, exact.key, "outsideAll");

    const clipping::Chunks chunks{lines};
    std::vector<clipping::Clipped> again(lines.size());
    expect(chunks.clipAll(lines, window, again) == inside.size(), exact.key, "Chunks");
    const std::vector<glm::dvec2> corners{{-2, 0}, {0, 0}, {0, 2}};
    clipping::PolylineRuns runs;
    clipping::clipPolyline(corners, window, runs);
    expect(runs.runs.size() == 1 && runs.points.size() == 3
               && runs.runs[0].begin == clipping::Edge::Left
               && runs.runs[0].end == clipping::Edge::Top,
           exact.key, "clipPolyline");
    clipping::clipClosedPolyline(corners, window, runs);
    expect(!runs.runs.empty(), exact.key, "clipClosedPolyline");
}

} // namespace

int main()
{
    expect(clipping::algorithms().size() >= keys.size(), "the catalogue", "rows are missing");
    for (const std::string_view key : keys) {
        const clipping::Algorithm* row = clipping::findAlgorithm(key);
        expect(row && row->key == key && !row->name.empty() && !row->idea.empty()
                   && row->year > 1900 && row->ulps <= 64
                   && clipping::findAlgorithm(row->abbreviation) == row,
               key, "the row");
    }
    expect(clipping::findAlgorithm("MD") == clipping::findAlgorithm("md"), "MD", "in any case");
    expect(!clipping::findAlgorithm("no such row"), "the catalogue", "a row that there is not");
    for (const clipping::Algorithm& row : clipping::algorithms())
        tryRow(row);
    tryTheRest();
    return faults == 0 ? 0 : 1;
}
