// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace clipping {

/// A winding number other than 0 of one area, which is that of a step of a region.
struct Winding {
    std::uint32_t step;
    int number;
    friend bool operator==(const Winding&, const Winding&) = default;
};

/// The winding numbers of all areas at a point that moves.
class Windings {
public:
    explicit Windings(std::size_t steps) : numbers_(steps, 0) {}

    void clear()
    {
        for (const std::uint32_t step : inside_)
            numbers_[step] = 0;
        inside_.clear();
    }
    void add(std::uint32_t step, int change)
    {
        if (change == 0)
            return;
        if (numbers_[step] == 0)
            inside_.push_back(step);
        numbers_[step] += change;
        if (numbers_[step] == 0)
            std::erase(inside_, step);
    }
    void appendTo(std::vector<Winding>& all) const
    {
        for (const std::uint32_t step : inside_)
            all.push_back({step, numbers_[step]});
    }

private:
    std::vector<int> numbers_;
    std::vector<std::uint32_t> inside_; ///< the steps whose number is not 0
};

} // namespace clipping
