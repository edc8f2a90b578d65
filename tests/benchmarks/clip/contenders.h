// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmarks/clip/data.h"
#include "tests/benchmarks/memory.h"
#include "tests/benchmarks/timing.h"

#ifdef WITH_THREADS
#include "clipping/parallel/clip_all.h"

#include <tbb/task_arena.h>
#endif

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
std::vector<Contender> memoryContenders(Data<T>& data)
{
    return {{"plain read", [&] { return plainRead(data.in().data(), data.in().size_bytes()); }},
            {"memcpy", [&] {
                 std::memcpy(static_cast<void*>(data.out.data()), data.in().data(),
                             data.in().size_bytes());
                 return std::uint64_t(data.out[data.out.size() / 2].source);
             }}};
}

template <class T>
std::vector<Contender> exactContenders(Data<T>& data)
{
    std::vector<Contender> all;
    for (const auto& set : clipping::instructionSets())
        if (set.available)
            all.push_back({nameOf(set), [&data, &set] {
                               return std::uint64_t(
                                   clipWith(set, data.batch(0, data.in().size())).pieces);
                           }});
    all.push_back({"exact, 8192 at a time", [&data] { return clipInBlocks(data); }});
    all.push_back({"exact, chunk boxes", [&data] {
                       return std::uint64_t(
                           data.chunks.clipAll(data.in(), data.scene.window, data.out));
                   }});
    return all;
}

/// Every other row of the catalogue, one segment after the other.
template <class T>
std::vector<Contender> scalarContenders(Data<T>& data)
{
    std::vector<Contender> all;
    for (const clipping::Algorithm& row : clipping::algorithms())
        if (const auto* uses = usesFor<T>(row); uses && row.key != "exact")
            all.push_back({std::string(row.name), [&data, uses] {
                               return std::uint64_t(
                                   uses->clipAll(data.in(), data.scene.window, data.out));
                           }});
    return all;
}

#ifdef WITH_THREADS
template <class T>
std::vector<Contender> threadContenders(Data<T>& data)
{
    static tbb::task_arena two(2);
    return {{"plain read, 2 threads",
             [&] { return two.execute([&] { return readOnAllThreads(data.in()); }); }},
            {"exact, 2 threads", [&] {
                 return two.execute([&] {
                     return std::uint64_t(
                         clipping::clipAllInParallel(data.in(), data.scene.window, data.out));
                 });
             }}};
}
#endif
