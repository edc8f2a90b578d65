// SPDX-License-Identifier: GPL-3.0-or-later
// How fast filled areas are clipped, beside the libraries that are installed; the results are
// compared first: area_clip_bench [SCALE [ROUNDS [CASE]]], with a part of a case's name
#include "clipping/area/clip_area.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/benchmarks/area_peers/peer.h"
#include "tests/benchmarks/processor_time.h"
#include "tests/benchmarks/region_shapes.h"
#include "tests/benchmarks/timing.h"

using namespace clipping;

namespace {

Area movedBy(Area area, const glm::dvec2& way)
{
    for (auto& p : area.points)
        p += way;
    return area;
}

/// Many small polygons, as a street map's blocks.
std::vector<Area> blocks(std::size_t count)
{
    RandomNumbers random(11);
    std::vector<Area> all;
    for (std::size_t i = 0; i < count; ++i) {
        Area block;
        const int corners = int(random.uniform(4, 10));
        const glm::dvec2 at(random.uniform(-500, 500), random.uniform(-500, 500));
        for (int j = 0; j < corners; ++j) {
            const double angle = 2 * std::numbers::pi * j / corners, r = random.uniform(2, 5);
            block.points.push_back(at + r * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        all.push_back(std::move(block));
    }
    return all;
}

/// Crosses itself wherever it can.
Area star(int points)
{
    Area area;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i * (points / 2) / points;
        area.points.push_back(glm::dvec2(400 * std::cos(angle), 400 * std::sin(angle)));
    }
    area.rule = FillRule::EvenOdd;
    return area;
}

/// Long edges beside each other, tilted by so many degrees: the teeth are as thick as their gaps.
Area comb(std::size_t teeth, double degrees)
{
    Area area;
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const auto add = [&](double x, double y) {
        area.points.push_back({c * x - s * y, s * x + c * y});
    };
    for (std::size_t i = 0; i < teeth; ++i) {
        const double x = 1000 * double(i) / double(teeth) - 500, next = x + 500 / double(teeth);
        add(x, 500), add(next, 500), add(next, -500), add(x + 1000 / double(teeth), -500);
    }
    add(500, -501), add(-500, -501);
    return area;
}

/// Edges that nearly meet in the middle.
Area rays(std::size_t count)
{
    Area area;
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const double angle = std::numbers::pi * double(i) / double(count), r = i % 2 ? 500 : 50;
        area.points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return area;
}

double areaOfRings(std::span<const glm::dvec2> points, std::span<const std::uint32_t> ends)
{
    double twice = 0;
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto &p = points[i], &q = points[i + 1 == end ? begin : i + 1];
            twice += p.x * q.y - p.y * q.x;
        }
        begin = end;
    }
    return twice / 2;
}

/// What is left of an area, given as points or prepared.
template <class Given>
double leftOf(const Given& given, const Area& area, const PreparedRegion& window)
{
    const ClippedArea left = clipArea(given, window);
    const auto size = static_cast<std::uint32_t>(area.points.size());
    if (left.part == AreaPart::Whole)
        return std::abs(areaOfRings(area.points, std::span(&size, 1)));
    return areaOfRings(left.points, left.ringEnds);
}

struct Case {
    const char* name;
    std::vector<Area> areas;
    Area window;
};

/// Milliseconds for one call, the median of some rounds; and what it returned.
template <class Call>
std::pair<double, double> timed(int rounds, Call call)
{
    std::vector<double> times;
    double result = 0;
    for (int round = -1; round < rounds; ++round) { // the first one is not counted
        const double start = processorTime();
        result = call();
        if (round >= 0)
            times.push_back(processorTime() - start);
    }
    return {median(times), result};
}

/// Whether all agree.
bool measure(const Case& what, int rounds)
{
    const PreparedRegion window({{{what.window}}});
    std::vector<PreparedRegion> prepared;
    for (const Area& area : what.areas)
        prepared.emplace_back(Region{{{area}}});
    const auto [ready, sum] = timed(rounds, [&] {
        double all = 0;
        for (std::size_t i = 0; i < prepared.size(); ++i)
            all += leftOf(prepared[i], what.areas[i], window);
        return all;
    });
    const auto [fromPoints, same] = timed(rounds, [&] {
        double all = 0;
        const PreparedRegion at({{{what.window}}});
        for (const Area& area : what.areas)
            all += leftOf(area, area, at);
        return all;
    });
    bool agree = sum == same;
    std::printf("| %s | %.2f | %.2f |", what.name, ready, fromPoints);
    for (const AreaPeer& peer : areaPeers()) {
        const auto data = peer.prepare(what.areas, what.window);
        const auto [took, other] = timed(rounds, [&] { return data->clipAll(); });
        const double off = std::abs(other - sum) / sum;
        std::printf(" %.2f (%.0e) |", took, off);
        agree = agree && (off < 1e-6 || !peer.isReferee);
    }
    std::printf("\n");
    return agree;
}

} // namespace

int main(int argc, char** argv)
{
    const double scale = argc > 1 ? std::atof(argv[1]) : 1;
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 9;
    const char* only = argc > 3 ? argv[3] : "";
    const auto many = static_cast<std::size_t>(10'000 * scale);
    std::printf("| areas, window | prepared, ms | from points, ms |");
    for (const AreaPeer& peer : areaPeers())
        std::printf(" %s, ms (off by) |", std::string(peer.name).c_str());
    std::printf("\n");
    const Area coast = coastLine(many), window = areaOf({{-200, -150}, {200, 150}});
    const std::vector<Case> cases{
        {"coast line of 10,000 edges, a window", {coast}, window},
        {"coast line of 10,000 edges, a circle of 64 edges", {coast}, circle(64, 400)},
        {"two coast lines of 10,000 edges", {coast}, movedBy(coast, {97, 41})},
        {"10,000 blocks, a window", blocks(many), window},
        {"10,000 blocks, a coast line of 10,000 edges", blocks(many), coast},
        {"star of 301 edges that cross each other, a window", {star(301)}, window},
        {"comb of 10,000 teeth, a window", {comb(many, 0)}, window},
        {"comb of 10,000 teeth, tilted, a window", {comb(many, 7)}, window},
        {"10,000 rays, a window", {rays(many)}, window},
    };
    bool agree = true;
    for (const Case& each : cases)
        if (std::strstr(each.name, only))
            agree = measure(each, rounds) && agree;
    if (!agree)
        std::printf("the results differ\n");
    return agree ? 0 : 1;
}
