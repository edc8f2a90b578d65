// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast `exact` clips many segments, beside plain reading and copying of the same bytes and
// beside other ways of clipping. Prints Markdown tables; README.md beside it keeps some.
//   clip_bench [SCENE|all] [MILLIONS] [ROUNDS]
#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <immintrin.h>
#include <numeric>

#include "tests/benchmarks/scenes.h"
#include "tests/benchmarks/timing.h"

using namespace clipping;

namespace {

/// Reads everything and nothing else, in vectors of 32 bytes.
[[gnu::target("avx2")]] std::uint64_t plainRead(const void* data, std::size_t bytes)
{
    const auto* words = static_cast<const __m256i*>(data);
    __m256i sums[4]{};
    for (std::size_t i = 0; i + 4 <= bytes / sizeof(__m256i); i += 4)
        for (std::size_t j = 0; j < 4; ++j)
            sums[j] = _mm256_add_epi64(sums[j], _mm256_loadu_si256(words + i + j));
    std::uint64_t parts[16];
    std::memcpy(parts, sums, sizeof parts);
    return std::accumulate(std::begin(parts), std::end(parts), std::uint64_t{});
}

template <class T>
BatchResult clipWith(const InstructionSet& set, const Batch<T>& batch)
{
    if constexpr (sizeof(T) == sizeof(double))
        return set.clip(batch);
    else
        return set.clipSingle(batch);
}

template <class T>
const Uses<BasicSegment<T>, BasicWindow<T>>* usesFor(const Algorithm& algorithm)
{
    if constexpr (sizeof(T) == sizeof(double))
        return &algorithm.corrected;
    else
        return algorithm.single;
}

std::string processor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

void printMachine()
{
    std::printf("Processor %s; instructions", processor().c_str());
    for (const InstructionSet& set : instructionSets())
        std::printf("%s %s%s", set.name == "portable" ? "" : ",", std::string(set.name).c_str(),
                    set.available ? "" : " (not here)");
    std::printf("; compiler %s\n", __VERSION__);
}

template <class T>
void bench(const SceneMaker<T>& maker, std::size_t count, int rounds)
{
    using S = BasicSegment<T>;
    const auto scene = maker.make(count);
    const std::span<const S> in = scene.segments;
    std::vector<BasicClipped<S>> out(count);
    std::memset(static_cast<void*>(out.data()), 1, out.size() * sizeof out[0]); // touch the pages
    std::size_t unsettled = 0;

    std::vector<Contender> all;
    all.push_back({"plain read", [&] { return plainRead(in.data(), in.size_bytes()); }});
    all.push_back({"memcpy", [&] {
                       std::memcpy(static_cast<void*>(out.data()), in.data(), in.size_bytes());
                       return std::uint64_t(out[count / 2].source);
                   }});
    for (const char* key : {"matthes-drakopoulos", "liang-barsky"})
        if (const Algorithm* row = findAlgorithm(key); row && usesFor<T>(*row))
            all.push_back({std::string(row->name), [&, uses = usesFor<T>(*row)] {
                               return std::uint64_t(uses->clipAll(in, scene.window, out));
                           }});
    for (const InstructionSet& set : instructionSets())
        if (set.available)
            all.push_back({"exact, " + std::string(set.name), [&] {
                               const auto result = clipWith<T>(
                                   set, {in.data(), 0, count, scene.window, out.data()});
                               unsettled = result.unsettled;
                               return std::uint64_t(result.pieces);
                           }});
    all.push_back({"exact, consumed in blocks", [&] {
                       std::uint64_t pieces = 0;
                       constexpr std::size_t block = 8192;
                       for (std::size_t first = 0; first < count; first += block)
                           pieces += clipBatch<T>({in.data(), first, std::min(first + block, count),
                                                   scene.window, out.data()})
                                         .pieces;
                       return pieces;
                   }});
    race(all, rounds);

    const Contender& read = all[0];
    const double perSegment = 1e9 / static_cast<double>(count);
    std::printf("\n### %s, %zu segments, %s\n", maker.name, count,
                sizeof(T) == sizeof(double) ? "double" : "float");
    std::printf("%.2f %% visible; %.5f %% left to the scalar algorithm\n\n",
                100.0 * double(all.back().answer) / double(count),
                100.0 * double(unsettled) / double(count));
    std::printf("| | ns a segment | speed of plain read (half of the rounds) | times "
                "Matthes-Drakopoulos |\n"
                "|---|---|---|---|\n");
    for (const Contender& who : all) {
        const Ratio r = ratio(read, who);
        std::printf("| %s | %.2f | %.3f (%.3f-%.3f) | %.1f |\n", who.name.c_str(),
                    median(who.seconds) * perSegment, r.middle, r.low, r.high,
                    ratio(all[2], who).middle);
    }
    std::fflush(stdout);
}

template <class T>
void benchAll(const std::string& scene, std::size_t count, int rounds)
{
    for (const auto& maker : benchmarkScenes<T>)
        if (scene == "all" || scene == maker.name)
            bench(maker, count, rounds);
}

} // namespace

int main(int argc, char** argv)
{
    const std::string scene = argc > 1 ? argv[1] : "all";
    const auto count = static_cast<std::size_t>((argc > 2 ? std::atof(argv[2]) : 1) * 1e6);
    const int rounds = argc > 3 ? std::atoi(argv[3]) : 9;
    printMachine();
    benchAll<double>(scene, count, rounds);
    benchAll<float>(scene, count, rounds);
}
