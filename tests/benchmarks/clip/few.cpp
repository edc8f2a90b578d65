// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/clip/few.h"

#include "clipping/clip.h"

#include <cstdio>

#include "tests/benchmarks/clip/data.h"
#include "tests/benchmarks/scenes.h"
#include "tests/benchmarks/timing.h"

namespace {

using namespace clipping;

/// A way to clip a few segments; returns the number of pieces.
template <class T>
using Way = std::size_t (*)(std::span<const BasicSegment<T>>, const BasicWindow<T>&,
                            std::span<BasicClipped<BasicSegment<T>>>);

template <class T>
std::size_t plainLoop(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
                      std::span<BasicClipped<BasicSegment<T>>> out)
{
    const auto& exact = *usesFor<T>(exactAlgorithm());
    std::size_t pieces = 0;
    for (std::uint32_t i = 0; i < in.size(); ++i)
        if (const auto piece = exact.clip(in[i], window))
            out[pieces++] = {*piece, i, 0};
    return pieces;
}
template <class T>
std::size_t ofTheRow(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
                     std::span<BasicClipped<BasicSegment<T>>> out)
{
    return usesFor<T>(exactAlgorithm())->clipAll(in, window, out);
}
template <class T>
std::size_t ofClip(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
                   std::span<BasicClipped<BasicSegment<T>>> out)
{
    return clipAll(SegmentsView<T>(in), window, Output<T>(out)).visible;
}

template <class T>
Contender contender(const char* name, Data<T>& data, std::size_t few, Way<T> way)
{
    return {name, [&data, few, way] {
                const auto in = data.in();
                std::uint64_t pieces = 0;
                for (std::size_t i = 0; i + few <= in.size(); i += few)
                    pieces += way(in.subspan(i, few), data.scene.window, data.out);
                return pieces;
            }};
}

template <class T>
bool printFewOf(Scene<T> scene, int rounds)
{
    Data<T> data(std::move(scene));
    bool agree = true;
    for (const std::size_t few : {1, 2, 3, 5, 7, 8, 10, 20, 50, 100}) {
        std::vector<Contender> all{contender<T>("loop", data, few, plainLoop<T>),
                                   contender<T>("row", data, few, ofTheRow<T>),
                                   contender<T>("clip.h", data, few, ofClip<T>)};
        race(all, rounds);
        agree = agree && all[1].answer == all[0].answer && all[2].answer == all[0].answer;
        const double segments = double(data.in().size() / few * few);
        std::printf("| %s, %s | %zu | %.1f | %.2f | %.2f |\n", data.scene.name.c_str(), numbers<T>,
                    few, median(all[0].seconds) / segments * 1e9, ratio(all[1], all[0]).middle,
                    ratio(all[2], all[0]).middle);
    }
    return agree;
}

} // namespace

bool printFew(int rounds)
{
    constexpr std::size_t count = 20'000;
    std::printf("\n## Few segments a call: time as a multiple of a loop over `clip`\n"
                "| scene | segments | loop, ns each | clipAll of `exact` | of clip.h |\n"
                "|---|---|---|---|---|\n");
    const auto& doubles = benchmarkScenes<double>;
    const bool ofPaper = printFewOf(doubles[0].make(count), rounds);
    const bool ofCut = printFewOf(doubles[2].make(count), rounds);
    return printFewOf(benchmarkScenes<float>[0].make(count), rounds) && ofPaper && ofCut;
}
