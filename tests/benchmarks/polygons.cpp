// SPDX-License-Identifier: GPL-3.0-or-later
// How long `exact` takes for convex polygons, compared with an axis-aligned window in the same
// rounds: polygons [LINES] [ROUNDS]. Prints ns a line, and the median ratio with the middle half of
// rounds.
#include "clipping/turned_window.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "tests/benchmarks/timing.h"

using namespace clipping;

namespace {

using Lines = std::vector<Segment>;

/// A sheet's lines, by two numbers from -1 to 1 for each end.
Lines lines(std::size_t count, Segment (*of)(double, double, double, double))
{
    std::mt19937_64 random(7);
    const auto number = [&random] { return double(random() >> 11) * 0x1p-52 - 1; };
    Lines all;
    for (std::size_t i = 0; i < count; ++i) {
        const double a = number(), b = number(), c = number();
        all.push_back(of(a, b, c, number()));
    }
    return all;
}
Segment paper(double a, double b, double c, double d)
{
    return {{960 * a, 720 * b}, {960 * c, 720 * d}};
}
Segment oneEndInside(double a, double b, double c, double d)
{
    const double angle = 3.2 * c, length = 400 + 200 * d;
    return {{50 * a, 40 * b},
            {50 * a + length * std::cos(angle), 40 * b + length * std::sin(angle)}};
}
Segment through(double a, double b, double c, double)
{
    const glm::dvec2 middle(50 * a, 40 * b), way(1e6 * std::cos(3.2 * c), 1e6 * std::sin(3.2 * c));
    return {middle - way, middle + way};
}

ConvexPolygon circle(int corners)
{
    ConvexPolygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = i * 6.283185307179586 / corners;
        polygon.corners.push_back({90 * std::cos(angle), 90 * std::sin(angle)});
    }
    return polygon;
}

} // namespace

int main(int argc, char** argv)
{
    const auto count = static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 1'000'000);
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 9;
    const Window window{{-100, -75}, {100, 75}};
    const TurnedWindow rotated = turned(window, 30);
    const auto& exact = exactAlgorithm();
    const struct {
        const char* name;
        Segment (*of)(double, double, double, double);
    } scenes[] = {{"paper", paper}, {"one end inside", oneEndInside}, {"through", through}};
    for (const auto& [name, of] : scenes) {
        const Lines in = lines(count, of);
        std::vector<Clipped> out(in.size());
        const auto at = [&](ConvexPolygon polygon) {
            return [&, polygon = std::move(polygon)] {
                return std::uint64_t(exact.polygon->clipAll(in, polygon, out));
            };
        };
        std::vector<Contender> all{
            {"window", [&] { return std::uint64_t(exact.corrected.clipAll(in, window, out)); }},
            {"rotated, polygon", at(cornersOf(rotated))},
            {"rotated, frame",
             [&] { return std::uint64_t(clipAllTurned(exact.corrected, in, rotated, out)); }},
            {"triangle", at({{{-100, -75}, {110, -60}, {10, 120}}})},
            {"circle of 64", at(circle(64))},
            {"circle of 1000", at(circle(1'000))}};
        race(all, rounds);
        for (const Contender& one : all) {
            const auto [middle, low, high] = ratio(one, all[0]);
            std::printf("%s, %s: %.2f ns, %.2f (%.2f-%.2f) of window, %llu pieces\n", name,
                        one.name.c_str(), median(one.seconds) / double(count) * 1e9, middle, low,
                        high, static_cast<unsigned long long>(one.answer));
        }
    }
}
