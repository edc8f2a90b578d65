// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/step_scene.h"

#include "app/overlays/polygon_edges.h"

#include <array>

namespace app {

namespace {

using clipping::Edge;

bool isOn(clipping::Edge edge, const Point& at, const clipping::Window& window)
{
    return edge != Edge::NoEdge && edge <= Edge::Top
           && at[clipping::axisOf(edge)] == clipping::levelOf(edge, window);
}

/// The edge of a step, unless the point lies on another edge.
Edge edgeOf(const NarratedStep& narrated, const Point& at, const clipping::Window& window)
{
    for (const Edge edge : {narrated.edge, Edge::Left, Edge::Right, Edge::Bottom, Edge::Top})
        if (isOn(edge, at, window))
            return edge;
    return narrated.edge;
}

CutPoint cutAt(const Point& at, int end, std::size_t step, const TracedLine& tracedLine,
               const NarratedStep& narrated)
{
    const bool atPolygon = !tracedLine.corners.empty();
    return {.at = at,
            .end = end,
            .edge = atPolygon ? Edge::NoEdge : edgeOf(narrated, at, tracedLine.window),
            .polygonEdge = atPolygon ? polygonEdgeAt(at, tracedLine.corners) : 0,
            .step = step};
}

/// Records the move of an end. The final rounding of an end when it is accepted is not a new cut;
/// neither is a return to the original end or to an earlier cut.
void noteCut(StepScene& scene, const CutPoint& cut, const Point& given, Mark mark)
{
    CutPoint* same = nullptr;
    for (CutPoint& earlier : scene.cuts) {
        if (earlier.end != cut.end)
            continue;
        if (mark == Mark::Accept && earlier.stands)
            earlier.at = cut.at;
        if (earlier.at == cut.at)
            same = &earlier;
        earlier.stands = false;
    }
    if (same)
        same->stands = true;
    else if (cut.at != given)
        scene.cuts.push_back(cut);
}

StepScene::State stateOf(Mark mark)
{
    return mark == Mark::Accept                           ? StepScene::State::Accepted
           : mark == Mark::Reject || mark == Mark::GiveUp ? StepScene::State::Rejected
                                                          : StepScene::State::Working;
}

/// The remaining line after a step: if it accepts, the visible part after the final rounding.
const clipping::Segment& leftAt(const NarratedStep& narrated, const Narration& narration)
{
    return narrated.mark == Mark::Accept && narration.visible ? *narration.visible : narrated.left;
}

/// Records the part between an end's place before and now.
void noteDiscarded(StepScene& scene, const Point& given, const Point& before, const Point& now)
{
    if (given != before)
        scene.discarded.push_back({given, before});
    if (before != now)
        scene.discardedNow.push_back({before, now});
}

} // namespace

StepScene stepScene(const TracedLine& tracedLine, const Narration& narration, std::size_t step)
{
    StepScene scene{.left = tracedLine.line, .discarded = {}, .discardedNow = {}, .step = step};
    if (step >= narration.steps.size())
        return scene;
    clipping::Segment before = tracedLine.line;
    for (std::size_t i = 0; i <= step; ++i) {
        const NarratedStep& narrated = narration.steps[i];
        before = scene.left;
        scene.left = leftAt(narrated, narration);
        const auto& [a, b] = tracedLine.line;
        for (const auto& [was, is, given, end] :
             {std::tuple(before.a, scene.left.a, a, 1), std::tuple(before.b, scene.left.b, b, 2)})
            if (was != is)
                noteCut(scene, cutAt(is, end, i, tracedLine, narrated), given, narrated.mark);
    }
    const NarratedStep& now = narration.steps[step];
    scene.state = stateOf(now.mark);
    scene.candidate = now.candidate;
    scene.edge = now.edge;
    scene.polygonEdge = now.polygonEdge;
    noteDiscarded(scene, tracedLine.line.a, before.a, scene.left.a);
    noteDiscarded(scene, tracedLine.line.b, before.b, scene.left.b);
    return scene;
}

std::vector<clipping::Segment> edgesOf(const TracedLine& tracedLine)
{
    const auto& [min, max] = tracedLine.window;
    std::vector<glm::dvec2> corners = tracedLine.corners;
    if (corners.empty())
        corners = {min, {max.x, min.y}, max, {min.x, max.y}};
    std::vector<clipping::Segment> edges;
    for (std::size_t i = 0; i < corners.size(); ++i)
        edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return edges;
}

} // namespace app
