// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/variants_of.h"

#include <functional>
#include <vector>

namespace app {

/// The numbers that are clipped.
enum class Precision : std::uint8_t { Double, Single };

/// "double", "single".
QString wordOf(Precision precision);

/// How lines are clipped.
struct Clipping {
    clipping::Window window;
    Precision precision = Precision::Double;
    std::size_t threads = 1; ///< at most mostThreads
};

/// Some lines of an experiment, and where what is visible of them goes.
class Block {
public:
    explicit Block(const Clipping& how);

    /// So many other lines, written by `fill`. With single precision, lines and window become what
    /// is nearest to them in float.
    void refill(std::size_t count, const std::function<void(std::span<clipping::Segment>)>& fill);
    std::span<const clipping::Segment> lines() const { return lines_; }
    const clipping::Window& window() const { return how_.window; }

    /// Clips them, which is what is timed, and says how many are visible. The variant has a
    /// form of this precision.
    std::size_t clip(const Variant& variant);
    /// So many pieces of what was clipped last.
    std::span<const clipping::Clipped> pieces(std::size_t count);

private:
    Clipping how_;
    std::vector<clipping::Segment> lines_;
    std::vector<clipping::Clipped> visible_;
    std::vector<clipping::BasicSegment<float>> singleLines_; ///< empty with double precision
    std::vector<clipping::BasicClipped<clipping::BasicSegment<float>>> singleVisible_;
};

} // namespace app
