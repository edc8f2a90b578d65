// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/formats/svg/gradient.h"

#include <algorithm>
#include <cmath>

namespace app::svg {

inline Colour colourOf(const Rgba& colour)
{
    const auto byte = [](double part) {
        return std::uint8_t(std::lround(std::clamp(part, 0.0, 1.0) * 255));
    };
    return {byte(colour[0]), byte(colour[1]), byte(colour[2]), byte(colour[3])};
}

/// The mean of colours. A colour counts as much as it is opaque, as it does to the eye.
class ColourSum {
public:
    void add(const Rgba& colour, double weight)
    {
        weight_ += weight;
        opaque_ += weight * colour[3];
        for (std::size_t i = 0; i < parts_.size(); ++i)
            parts_[i] += weight * colour[3] * colour[i];
    }
    /// Transparent black if all colours are transparent, or there are none.
    Colour mean() const
    {
        if (!(opaque_ > 0))
            return {0, 0, 0, 0};
        return colourOf(
            {parts_[0] / opaque_, parts_[1] / opaque_, parts_[2] / opaque_, opaque_ / weight_});
    }

private:
    double weight_ = 0, opaque_ = 0;
    std::array<double, 3> parts_{};
};

} // namespace app::svg
