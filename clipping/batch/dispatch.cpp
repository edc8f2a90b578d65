// SPDX-License-Identifier: MIT
#include "clipping/batch/sets.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <array>
#include <functional>

namespace clipping {
namespace {

#if defined(__x86_64__) && defined(__GNUC__)
bool hasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool hasAvx512()
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
           && __builtin_cpu_supports("avx512vl");
}
#else
bool hasAvx2() { return false; }
bool hasAvx512() { return false; }
#endif

InstructionSet whereAvailable(InstructionSet set, bool onThisProcessor)
{
    set.available = set.clip && onThisProcessor;
    return set;
}

const InstructionSet& fastest()
{
    const auto all = instructionSets();
    static const InstructionSet& set =
        *std::find_if(all.rbegin(), all.rend(), std::mem_fn(&InstructionSet::available));
    return set;
}

/// So few segments are faster one by one: their vectors would be filled in part only.
constexpr std::size_t few = 8;

template <class AnyBatch, class Window>
BatchResult clipFew(const AnyBatch& batch, const Window& window)
{
    std::array<std::uint32_t, few> indices;
    const std::size_t count = batch.end - batch.begin;
    for (std::size_t i = 0; i < count; ++i)
        indices[i] = static_cast<std::uint32_t>(batch.begin + i);
    return {clipOneByOne(batch.segments, indices.data(), count, window, batch.out), 0};
}

template <class AnyBatch>
bool isFew(const AnyBatch& batch)
{
    return batch.end - batch.begin < few;
}

} // namespace

std::span<const InstructionSet> instructionSets()
{
    static const std::array all{
        whereAvailable(portableSet, true),
        whereAvailable(avx2Set, hasAvx2()),
        whereAvailable(avx512Set, hasAvx512()),
    };
    return all;
}

template <>
BatchResult clipBatch(const Batch<double>& batch)
{
    return isFew(batch) ? clipFew(batch, batch.window) : fastest().clip(batch);
}

template <>
BatchResult clipBatch(const Batch<float>& batch)
{
    return isFew(batch) ? clipFew(batch, batch.window) : fastest().clipSingle(batch);
}

BatchResult clipBatch(const PolygonBatch& batch)
{
    return isFew(batch) ? clipFew(batch, *batch.polygon) : fastest().clipPolygon(batch);
}

} // namespace clipping
