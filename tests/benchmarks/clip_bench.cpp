// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast `exact` clips many segments, beside plain reading and copying of the same bytes and
// beside other ways of clipping. Prints Markdown tables; README.md beside it keeps some.
//   clip_bench [SCENE|all] [MILLIONS] [ROUNDS]
#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"
#include "clipping/chunks.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "tests/benchmarks/memory.h"
#include "tests/benchmarks/scenes.h"
#include "tests/benchmarks/timing.h"

#ifdef WITH_THREADS
#include "clipping/parallel/clip_all.h"
#endif

using namespace clipping;

namespace {

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

std::string nameOf(const InstructionSet& set) { return "exact, " + std::string(set.name); }
const InstructionSet& fastestSet()
{
    const InstructionSet* fastest = nullptr;
    for (const InstructionSet& set : instructionSets())
        if (set.available)
            fastest = &set;
    return *fastest;
}

/// A scene, what it is clipped into (its pages touched), and the boxes of its chunks.
template <class T>
struct Data {
    using S = BasicSegment<T>;
    Scene<T> scene;
    std::vector<BasicClipped<S>> out;
    BasicChunks<T> chunks;

    explicit Data(Scene<T> of) : scene(std::move(of)), out(scene.segments.size()), chunks(in())
    {
        std::memset(static_cast<void*>(out.data()), 1, out.size() * sizeof out[0]);
    }
    std::span<const S> in() const { return scene.segments; }
    Batch<T> batch(std::size_t begin, std::size_t end)
    {
        return {scene.segments.data(), begin, end, scene.window, out.data()};
    }
};

/// Clips 8192 at a time into the same small buffer: whoever consumes the pieces at once does so.
template <class T>
std::uint64_t clipInBlocks(Data<T>& data)
{
    std::uint64_t pieces = 0;
    const std::size_t count = data.in().size(), block = 8192;
    for (std::size_t first = 0; first < count; first += block)
        pieces += clipBatch(data.batch(first, std::min(first + block, count))).pieces;
    return pieces;
}

template <class T>
std::vector<Contender> contendersFor(Data<T>& data)
{
    std::vector<Contender> all;
    const auto add = [&](std::string name, std::function<std::uint64_t()> run) {
        all.push_back({std::move(name), std::move(run)});
    };
    add("plain read", [&] { return plainRead(data.in().data(), data.in().size_bytes()); });
    add("memcpy", [&] {
        std::memcpy(static_cast<void*>(data.out.data()), data.in().data(), data.in().size_bytes());
        return std::uint64_t(data.out[data.out.size() / 2].source);
    });
    for (const char* key : {"matthes-drakopoulos", "liang-barsky"})
        if (const Algorithm* row = findAlgorithm(key); row && usesFor<T>(*row))
            add(std::string(row->name), [&data, uses = usesFor<T>(*row)] {
                return std::uint64_t(uses->clipAll(data.in(), data.scene.window, data.out));
            });
    for (const InstructionSet& set : instructionSets())
        if (set.available)
            add(nameOf(set), [&] {
                return std::uint64_t(clipWith(set, data.batch(0, data.in().size())).pieces);
            });
    add("exact, 8192 at a time", [&] { return clipInBlocks(data); });
    add("exact, chunk boxes",
        [&] { return std::uint64_t(data.chunks.clipAll(data.in(), data.scene.window, data.out)); });
#ifdef WITH_THREADS
    add("plain read, all threads", [&] { return readOnAllThreads(data.in()); });
    add("exact, all threads", [&] {
        return std::uint64_t(clipAllInParallel<T>(data.in(), data.scene.window, data.out));
    });
#endif
    return all;
}

const Contender* find(const std::vector<Contender>& all, std::string_view name)
{
    const auto found = std::ranges::find(all, name, &Contender::name);
    return found == all.end() ? nullptr : &*found;
}

void printTable(const std::vector<Contender>& all, std::size_t count)
{
    const Contender* read = find(all, "plain read");
    const Contender* scalar = find(all, "Matthes-Drakopoulos");
    std::printf("| | ns a segment | speed of plain read (middle half of the rounds) | times scalar "
                "Matthes-Drakopoulos |\n|---|---|---|---|\n");
    for (const Contender& who : all) {
        const Ratio r = ratio(*read, who);
        std::printf("| %s | %.2f | %.3f (%.3f-%.3f) |", who.name.c_str(),
                    median(who.seconds) * 1e9 / double(count), r.middle, r.low, r.high);
        scalar ? std::printf(" %.1f |\n", ratio(*scalar, who).middle) : std::printf(" |\n");
    }
    if (const Contender* threads = find(all, "exact, all threads")) {
        const double reading = ratio(*read, *find(all, "plain read, all threads")).middle;
        const double clipping = ratio(*find(all, nameOf(fastestSet())), *threads).middle;
        std::printf("\nAll threads: reading gains %.2f, clipping %.2f, which is %.2f of it.\n",
                    reading, clipping, clipping / reading);
    }
}

template <class T>
void bench(const SceneMaker<T>& maker, std::size_t count, int rounds)
{
    Data<T> data(maker.make(count));
    auto all = contendersFor(data);
    race(all, rounds);
    const BatchResult result = clipWith(fastestSet(), data.batch(0, count));
    for (const Contender& who : all)
        if (who.name.starts_with("exact") && who.answer != result.pieces)
            std::printf("WRONG: %s\n", who.name.c_str());
    std::printf("\n### %s, %zu segments, %s\n%.2f %% visible; %.5f %% left to the scalar "
                "algorithm\n\n",
                maker.name, count, sizeof(T) == sizeof(double) ? "double" : "float",
                100.0 * double(result.pieces) / double(count),
                100.0 * double(result.unsettled) / double(count));
    printTable(all, count);
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
