// SPDX-License-Identifier: GPL-3.0-or-later
// How fast covered lines are removed: benchmarks.occlude [SCALE [ROUNDS]]
#include "app/cut/occlude.h"

#include "app/document/document_builder.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "tests/benchmarks/processor_time.h"
#include "tests/benchmarks/timing.h"

using namespace app;

namespace {

struct Case {
    const char* name;
    int corners;
    double radius; ///< the mean, in a drawing of 1000 × 1000
};

Document shapes(const Case& what, std::size_t count)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(0, 1000), share(0.5, 1.5);
    DocumentBuilder builder;
    builder.open({});
    for (std::size_t i = 0; i < count; ++i) {
        const Point centre(place(random), place(random));
        const double radius = what.radius * share(random);
        const auto corner = [&](int k) {
            const double angle = 2 * std::numbers::pi * k / what.corners + double(i);
            return centre + radius * share(random) * Point(std::cos(angle), std::sin(angle));
        };
        Subpath path{corner(0), {}, true};
        for (int k = 1; k < what.corners; ++k)
            path.segments.push_back({corner(k)});
        builder.add({Path({&path, 1}), {.stroke = Colour{}, .fill = Colour{255, 255, 255}}});
    }
    builder.close();
    return builder.take({});
}

} // namespace

int main(int argc, char** argv)
{
    const double scale = argc > 1 ? std::atof(argv[1]) : 1;
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    const auto count = std::size_t(10'000 * scale);
    bool right = true;
    std::printf("| shapes | ms | lines before | after | shapes gone |\n");
    for (const Case& each : {Case{"of 4 corners, few overlap", 4, 3},
                             Case{"of 4 corners, each overlaps about 10", 4, 10},
                             Case{"of 30 corners, each overlaps about 10", 30, 10},
                             Case{"of 30 corners, each overlaps about 100", 30, 30},
                             Case{"of 30 corners, each overlaps about 1,000", 30, 100}}) {
        const Document document = shapes(each, count);
        std::vector<double> times;
        CutCounts counts;
        for (int round = 0; round < rounds; ++round) {
            const double start = processorTime();
            counts = occlude(document, {}).counts;
            times.push_back(processorTime() - start);
        }
        std::printf("| %zu %s | %.0f | %zu | %zu | %zu |\n", count, each.name, median(times),
                    counts.segmentsBefore, counts.segmentsAfter, counts.gone);
        right = right && counts.fillsRemoved == count && counts.cut > 0;
    }
    return right ? 0 : 1;
}
