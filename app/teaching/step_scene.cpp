// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/step_scene.h"

#include <array>

namespace app {

namespace {

using clipping::Edge;

/// The edge of a step, or the one that the point lies on.
Edge edgeOf(const Moment& moment, const Point& at, const clipping::Window& window)
{
    if (moment.edge != Edge::None)
        return moment.edge;
    for (const Edge edge : {Edge::Left, Edge::Right, Edge::Bottom, Edge::Top})
        if (at[clipping::axisOf(edge)] == clipping::levelOf(edge, window))
            return edge;
    return Edge::None;
}

/// Writes down that an end has moved. The last rounding of an end, as it is accepted, is no new
/// cut.
void noteCut(StepScene& scene, const CutPoint& cut, Mark mark)
{
    for (CutPoint& earlier : scene.cuts) {
        if (earlier.end != cut.end || !earlier.stands)
            continue;
        if (mark == Mark::Accept) {
            earlier.at = cut.at;
            return;
        }
        earlier.stands = false;
    }
    scene.cuts.push_back(cut);
}

StepScene::State stateOf(Mark mark)
{
    return mark == Mark::Accept                           ? StepScene::State::Accepted
           : mark == Mark::Reject || mark == Mark::GiveUp ? StepScene::State::Rejected
                                                          : StepScene::State::Working;
}

/// What a moment leaves: as it accepts, what is visible, after the last rounding.
const clipping::Segment& leftAt(const Moment& moment, const Walk& walk)
{
    return moment.mark == Mark::Accept && walk.visible ? *walk.visible : moment.left;
}

/// From where an end was to where it is, over the steps up to one.
void noteDiscarded(StepScene& scene, const Point& given, const Point& before, const Point& now)
{
    if (given != before)
        scene.discarded.push_back({given, before});
    if (before != now)
        scene.discardedNow.push_back({before, now});
}

} // namespace

StepScene stepScene(const Specimen& specimen, const Walk& walk, std::size_t step)
{
    StepScene scene{.left = specimen.line, .discarded = {}, .discardedNow = {}, .step = step};
    if (step >= walk.moments.size())
        return scene;
    clipping::Segment before = specimen.line;
    for (std::size_t i = 0; i <= step; ++i) {
        const Moment& moment = walk.moments[i];
        before = scene.left;
        scene.left = leftAt(moment, walk);
        for (const auto& [was, is, end] :
             {std::tuple(before.a, scene.left.a, 1), std::tuple(before.b, scene.left.b, 2)})
            if (was != is)
                noteCut(
                    scene,
                    {.at = is, .end = end, .edge = edgeOf(moment, is, specimen.window), .step = i},
                    moment.mark);
    }
    const Moment& now = walk.moments[step];
    scene.state = stateOf(now.mark);
    scene.candidate = now.candidate;
    scene.edge = now.edge;
    noteDiscarded(scene, specimen.line.a, before.a, scene.left.a);
    noteDiscarded(scene, specimen.line.b, before.b, scene.left.b);
    return scene;
}

} // namespace app
