// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how long it takes to find the place that the pointer snaps to: snapping [SEGMENTS]
#include "app/document/document_builder.h"
#include "app/view/snapping/snapper.h"

#include <QCoreApplication>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "tests/benchmarks/timing.h"

namespace {

using app::Point;
using Random = std::mt19937_64;
constexpr int queries = 300;
const clipping::Window screen{{0, 0}, {1280, 800}};
const app::Page page{{0, 0}, {1280, 800}, {1280, app::Unit::Px}, {800, app::Unit::Px}};

/// In milliseconds; what others do on the machine does not count.
double processorTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

Point somewhere(Random& random)
{
    return {std::uniform_real_distribution<double>(0, 1280)(random),
            std::uniform_real_distribution<double>(0, 800)(random)};
}
clipping::Segment shortLine(Random& random)
{
    const Point from = somewhere(random);
    const double angle = std::uniform_real_distribution<double>(0, 2 * M_PI)(random);
    return {from, from + 10.0 * Point(std::cos(angle), std::sin(angle))};
}
clipping::Segment longLine(Random& random) { return {somewhere(random), somewhere(random)}; }
clipping::Segment heap(Random& random)
{
    const Point by = somewhere(random) * 0.01;
    return {Point(640, 400) - by, Point(640, 400) + by};
}

void report(const char* name, double zoom, const char* what, const std::vector<double>& times,
            std::size_t found)
{
    std::printf("%s, zoom %g, %s: median %.3f ms, maximum %.3f ms, found %zu of %d\n", name, zoom,
                what, median(times), *std::ranges::max_element(times), found, queries);
}

void measure(const char* name, std::size_t count, clipping::Segment (*line)(Random&), double zoom)
{
    Random random(1);
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    for (std::size_t i = 0; i < count; ++i)
        builder.add({app::Path(line(random)), {.stroke = app::Colour{}}});
    builder.close();
    const app::EditedDocument document(builder.take(page));
    const app::Scene scene(document);
    const app::Picking picking(document, scene);
    const app::Snapper snapper(document, scene, picking);
    std::vector<double> times;
    std::size_t found = 0;
    for (int i = -1; i < queries; ++i) {
        const Point pointer = line == heap ? Point(640.3, 400.2) : somewhere(random);
        const double start = processorTime();
        const app::SnapQuery query{
            .pointer = pointer, .radius = 8 / zoom, .from = Point(20, 30), .seen = screen};
        const bool one = snapper.at(query).has_value();
        const double took = processorTime() - start;
        if (i >= 0) { // the first one builds the index
            times.push_back(took);
            found += one;
        } else
            std::printf("%s, zoom %g: first query %.1f ms\n", name, zoom, took);
    }
    report(name, zoom, "pointer", times, found);
    times.clear();
    found = 0;
    const auto own = app::ownPointsOf({{0, 0}, {60, 40}});
    for (int i = 0; i < queries; ++i) {
        const Point by = line == heap ? Point(640.3, 400.2) : somewhere(random);
        const app::SnapQuery query{.pointer = {}, .radius = 8 / zoom, .seen = screen};
        const double start = processorTime();
        found += snapper.moved(own, by, query).place.has_value();
        times.push_back(processorTime() - start);
    }
    report(name, zoom, "moved box", times, found);
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const std::size_t count = argc > 1 ? std::stoul(argv[1]) : 1'000'000;
    measure("short lines", count, shortLine, 1);
    measure("short lines", count, shortLine, 20);
    measure("long lines", count, longLine, 1);
    measure("long lines", count, longLine, 20);
    measure("100,000 lines through one point", 100'000, heap, 1);
    return 0;
}
