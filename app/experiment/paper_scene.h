// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <random>
#include <span>

namespace app {

/// The space and the window of the experiment in the paper.
constexpr clipping::Window paperSpace{{-960, -720}, {960, 720}};
constexpr clipping::Window paperWindow{{-100, -75}, {100, 75}};

/// The paper's random lines, both ends anywhere in the space: an endless sequence that depends on
/// the seed alone, the same on every machine (std::uniform_real_distribution is not).
class PaperScene {
public:
    explicit PaperScene(std::uint64_t seed) : random_(seed) {}

    /// The next lines of the sequence.
    void fill(std::span<clipping::Segment> lines);

private:
    std::mt19937_64 random_;
};

} // namespace app
