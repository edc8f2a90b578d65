// SPDX-License-Identifier: GPL-3.0-or-later
// How fast segments are clipped at areas of any shape, beside `exact` at the area's bounding box:
// region_clip_bench [MILLIONS [ROUNDS [REGION]]], with a part of a region's name
#include "clipping/algorithm.h"
#include "clipping/region/region.h"

#include <glm/common.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/benchmarks/map_lines.h"
#include "tests/benchmarks/processor_time.h"
#include "tests/benchmarks/region_shapes.h"
#include "tests/benchmarks/timing.h"

using namespace clipping;

namespace {

Window boxOf(const Area& area)
{
    Window box{area.points[0], area.points[0]};
    for (const auto& p : area.points)
        box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

/// Five windows of that size, each of which partly covers the next.
Region fiveOf(const Area& area)
{
    Region region;
    for (int i = 0; i < 5; ++i) {
        Area moved = area;
        for (auto& p : moved.points)
            p += glm::dvec2(60.0 * i - 120, 20.0 * i - 40);
        region.steps.push_back(
            {std::move(moved), i == 3 ? AreaOperation::CutOut : AreaOperation::Add});
    }
    return region;
}

/// Short lines anywhere on the sheet.
Scene<double> hatching(std::size_t count)
{
    return sceneOf<double>("short lines", count, [](RandomNumbers& random, auto& to) {
        const auto a = anywhere<double>(random, 600, 600);
        to.push_back({a, a + anywhere<double>(random, 2, 2)});
    });
}

struct Case {
    const char* name;
    Region region;
    Window box; ///< clipped at by `exact`
};

void measure(const Case& what, const Scene<double>& scene, int rounds)
{
    const auto& segments = scene.segments;
    const PreparedRegion region(what.region);
    std::vector<RegionPiece> pieces(segments.size() + 1'000);
    std::vector<Clipped> clipped(segments.size());
    const auto clipAtRegion = [&] {
        std::uint64_t written = 0;
        for (RegionProgress at; at.segment < segments.size();) {
            at = clipAll(segments, region, pieces, at);
            written += at.written;
        }
        return written;
    };
    std::vector<Contender> both{
        {"region", clipAtRegion},
        {"exact", [&] { return exactAlgorithm().corrected.clipAll(segments, what.box, clipped); }},
        {"prepare", [&] { return std::uint64_t(PreparedRegion(what.region).edge(1).step); }}};
    for (int round = -1; round < rounds; ++round) // the first one is not counted
        for (Contender& who : both) {
            const double start = processorTime();
            who.answer = who.run();
            if (round >= 0)
                who.seconds.push_back(processorTime() - start);
        }
    std::printf("| %s, %s, %zu | %.1f | %.1f | %.1f | %llu |\n", what.name, scene.name.c_str(),
                segments.size(), median(both[0].seconds), median(both[1].seconds),
                median(both[2].seconds), static_cast<unsigned long long>(both[0].answer));
}

} // namespace

int main(int argc, char** argv)
{
    const auto count = static_cast<std::size_t>((argc > 1 ? std::atof(argv[1]) : 1) * 1e6);
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 9;
    std::printf("| region, lines | ms | `exact` at its box, ms | preparing, ms | pieces |\n"
                "|---|---|---|---|---|\n");
    const Area round = circle(64, 100), coast = coastLine(10'000);
    const Area window = areaOf(paperWindow<double>());
    const std::vector<Case> cases{
        {"a window", {{{window}}}, paperWindow<double>()},
        {"a circle of 64 edges", {{{round}}}, boxOf(round)},
        {"a coast line of 10,000 edges", {{{coast}}}, boxOf(coast)},
        {"five windows", fiveOf(window), paperWindow<double>()},
    };
    const char* only = argc > 3 ? argv[3] : "";
    for (const Case& each : cases)
        for (const auto make : {paperScene<double>, hatching, strokes<double>, mapLines})
            if (std::strstr(each.name, only))
                measure(each, make(count), rounds);
}
