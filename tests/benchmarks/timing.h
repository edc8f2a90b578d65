// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Something that is timed beside others on the same data.
struct Contender {
    std::string name;
    std::function<std::uint64_t()> run; ///< the answer, so that nobody can leave the work out
    std::vector<double> seconds{};
    std::uint64_t answer = 0;
};

/// The middle one.
inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// A quotient of times taken in the same round: its median, and the middle half of all rounds.
struct Ratio {
    double middle, low, high;
};
inline Ratio spread(std::vector<double> all)
{
    std::ranges::sort(all);
    return {all[all.size() / 2], all[all.size() / 4], all[all.size() * 3 / 4]};
}
inline std::vector<double> quotients(const Contender& slow, const Contender& fast)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < slow.seconds.size(); ++i)
        all.push_back(slow.seconds[i] / fast.seconds[i]);
    return all;
}
inline Ratio ratio(const Contender& slow, const Contender& fast)
{
    return spread(quotients(slow, fast));
}

/// Lets everybody run once a round, beginning with another one each round, caches cold. The first
/// round is not counted.
inline void race(std::vector<Contender>& contenders, int rounds)
{
    static std::vector<std::uint64_t> other(12 << 20,
                                            1); // 96 MiB, to drive all else from the caches
    for (int round = -1; round < rounds; ++round)
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            auto& who = contenders[(i + static_cast<std::size_t>(round + 1)) % contenders.size()];
            for (auto& word : other)
                ++word;
            const auto start = std::chrono::steady_clock::now();
            who.answer = who.run();
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
            if (round >= 0)
                who.seconds.push_back(took.count());
        }
}
