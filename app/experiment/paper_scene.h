// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/random.h"

#include <span>

namespace app {

/// The space and the window of the paper's experiment.
constexpr clipping::Window paperSpace{{-960, -720}, {960, 720}};
constexpr clipping::Window paperWindow{{-100, -75}, {100, 75}};

/// The paper's random lines, both ends anywhere in the space: an unlimited sequence that depends
/// only on the seed and the space, the same on every machine.
class PaperScene {
public:
    explicit PaperScene(std::uint64_t seed, const clipping::Window& space = paperSpace)
        : random_(seed), space_(space)
    {
    }

    /// The next lines of the sequence.
    void fill(std::span<clipping::Segment> lines);

private:
    Random random_;
    clipping::Window space_;
};

} // namespace app
