// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <immintrin.h>
#include <numeric>
#include <span>

#ifdef WITH_THREADS
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#endif

/// Reads everything and nothing else, in vectors of 32 bytes: what any pass over the data costs.
[[gnu::target("avx2")]] inline std::uint64_t plainRead(const void* data, std::size_t bytes)
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

#ifdef WITH_THREADS
template <class S>
std::uint64_t readOnAllThreads(std::span<const S> in)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, in.size(), 8192), std::uint64_t{},
        [&](const auto& range, std::uint64_t sum) {
            return sum + plainRead(in.data() + range.begin(), range.size() * sizeof(S));
        },
        std::plus{});
}
#endif
