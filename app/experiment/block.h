// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/experiment/shaped_window.h"

#include <QString>

#include <functional>
#include <span>
#include <vector>

namespace app {

/// Every form of these algorithms, the corrected forms first.
std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms);

/// The algorithms that have this form, in this form.
std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms,
                                clipping::Form form);

/// "corrected", "published".
QString wordOf(clipping::Form form);

/// The number type of the lines that are clipped.
enum class Precision : std::uint8_t { Double, Single };

/// "double", "single".
QString wordOf(Precision precision);

/// How lines are clipped.
struct Clipping {
    clipping::Window window;
    Precision precision = Precision::Double;
    std::size_t threads = 1; ///< at most mostThreads
    /// A window that is no rectangle; only in double precision and on one thread.
    std::shared_ptr<const ShapedWindow> shape{};
};

/// Some lines of an experiment, and a buffer for their visible pieces.
class Block {
public:
    explicit Block(const Clipping& how);

    /// Replaces the lines by `count` lines written by `fill`. With single precision, lines and
    /// window are rounded to the nearest float.
    void refill(std::size_t count, const std::function<void(std::span<clipping::Segment>)>& fill);
    std::span<const clipping::Segment> lines() const { return lines_; }
    const clipping::Window& window() const { return how_.window; }

    /// Clips the lines and returns how many are visible. Only this call is timed. The variant must
    /// have a form of this precision.
    std::size_t clip(const Variant& variant);
    /// The first `count` pieces of the last clipping.
    std::span<const clipping::Clipped> pieces(std::size_t count);

private:
    Clipping how_;
    std::vector<clipping::Segment> lines_;
    std::vector<clipping::Clipped> visible_;
    std::vector<clipping::BasicSegment<float>> singleLines_; ///< empty with double precision
    std::vector<clipping::BasicClipped<clipping::BasicSegment<float>>> singleVisible_;
};

} // namespace app
