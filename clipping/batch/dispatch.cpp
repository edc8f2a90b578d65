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
    return fastest().clip(batch);
}

template <>
BatchResult clipBatch(const Batch<float>& batch)
{
    return fastest().clipSingle(batch);
}

BatchResult clipBatch(const PolygonBatch& batch) { return fastest().clipPolygon(batch); }

} // namespace clipping
