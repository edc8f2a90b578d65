// SPDX-License-Identifier: GPL-3.0-or-later
// How fast lines are clipped at polygon windows, beside the libraries that are installed; the
// results are compared first: line_clip_bench [MILLIONS [ROUNDS [WINDOW]]], with a part of a
// window's name. A library that is slower clips fewer lines, the first ones.
#include "clipping/region/catalogue.h"
#include "clipping/turned_window.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/benchmarks/line_peers/peer.h"
#include "tests/benchmarks/map_lines.h"
#include "tests/benchmarks/processor_time.h"
#include "tests/benchmarks/region_shapes.h"
#include "tests/benchmarks/timing.h"

using namespace clipping;

namespace {

using Lines = std::span<const Segment>;

/// A row of the catalogue, for comparison with the peers.
KeptLines clippedBy(const RegionAlgorithm& row, Lines lines, const PreparedRegion& window,
                    std::vector<RegionPiece>& out, bool isMeasured)
{
    KeptLines kept;
    for (RegionProgress at; at.segment < lines.size();) {
        at = row.clipAll(lines, window, out, at);
        for (const RegionPiece& piece : std::span(out).first(isMeasured ? at.written : 0)) {
            const double length = glm::distance(piece.segment.a, piece.segment.b);
            kept.length += length;
            kept.pieces += length > 0;
        }
    }
    return kept;
}

/// Nanoseconds of processor time for one line: the median of some rounds. The first round is not
/// counted.
template <class Call>
double timed(std::size_t lines, int rounds, Call call)
{
    std::vector<double> times;
    for (int round = -1; round < rounds; ++round) {
        const double start = processorTime();
        call();
        if (round >= 0)
            times.push_back(processorTime() - start);
    }
    return median(times) * 1e6 / double(lines);
}

constexpr double fewMilliseconds = 200;

/// As many lines as take a fifth of a second, or all.
std::size_t affordable(const LinePeer& peer, Lines lines, const Area& window)
{
    for (std::size_t count = 100;; count *= 4) {
        if (count >= lines.size())
            return lines.size();
        const auto data = peer.prepare(lines.first(count), window);
        const double start = processorTime();
        data->clipAll();
        if (processorTime() - start > fewMilliseconds)
            return count;
    }
}

/// Whether the results agree.
bool measure(const char* name, const Area& window, const Scene<double>& scene, int rounds)
{
    const Lines all(scene.segments);
    const PreparedRegion region({{{window}}, Keep::Inside});
    std::vector<RegionPiece> out(all.size() + 1'000);
    const RegionAlgorithm& exact = *findRegionAlgorithm("exact");
    const double ours =
        timed(all.size(), rounds, [&] { clippedBy(exact, all, region, out, false); });
    std::printf("| %s, %s | %.1f |", name, scene.name.c_str(), ours);
    bool agree = true;
    double fastest = INFINITY;
    for (const LinePeer& peer : linePeers()) {
        const Lines lines = all.first(affordable(peer, all, window));
        const auto data = peer.prepare(lines, window);
        const KeptLines theirs = data->clipAll(), mine = clippedBy(exact, lines, region, out, true);
        const double off = std::abs(theirs.length - mine.length) / std::max(mine.length, 1e-300);
        const double took = timed(lines.size(), rounds, [&] { data->clipAll(); });
        std::printf(" %.0f (%.0e, %+lld) |", took, off,
                    static_cast<long long>(theirs.pieces) - static_cast<long long>(mine.pieces));
        agree = agree && (off < 1e-6 || !peer.isReferee);
        fastest = std::min(fastest, took);
    }
    std::printf(" %.1f |\n", fastest / ours);
    return agree;
}

} // namespace

int main(int argc, char** argv)
{
    const auto count = static_cast<std::size_t>((argc > 1 ? std::atof(argv[1]) : 1) * 1e6);
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    const char* only = argc > 3 ? argv[3] : "";
    for (const std::string_view missing : missingLinePeers())
        std::printf("left out, as it is not installed: %s\n", std::string(missing).c_str());
    std::printf(
        "Nanoseconds a line; in brackets how far the length is off, and how many pieces more.\n"
        "| window, lines | exact |");
    for (const LinePeer& peer : linePeers())
        std::printf(" %s |", std::string(peer.name).c_str());
    std::printf(" fastest peer / exact |\n");
    const struct {
        const char* name;
        Area window;
    } cases[] = {
        {"rotated rectangle", {cornersOf(turned(paperWindow<double>(), 30)).corners}},
        {"circle of 64 edges", circle(64, 100)},
        {"coast line of 10,000 edges", simpleCoastLine(10'000)},
    };
    bool agree = true;
    for (const auto& [name, window] : cases)
        for (const auto make : {paperScene<double>, mapLines})
            if (std::strstr(name, only))
                agree = measure(name, window, make(count), rounds) && agree;
    if (!agree)
        std::printf("the results differ\n");
    return agree ? 0 : 1;
}
