// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/scene/scene_lines.h"

#include <QString>

#include <span>
#include <stop_token>
#include <vector>

namespace app {

/// How one variant differs from `exact`, which is never wrong, on many segments.
struct Disagreement {
    Variant variant;
    std::size_t lost = 0;  ///< visible segments that it drops
    std::size_t shown = 0; ///< invisible segments that it keeps
    std::size_t moved = 0; ///< visible segments with an end farther off than both contracts allow
    std::vector<std::uint32_t> segments{}; ///< indices of all these segments, ascending

    bool none() const { return segments.empty(); }
};

/// The verdict on a drawing and a window: one entry for each corrected form of the catalogue that
/// differs from `exact`, and one for `chosen` if it is a published form that differs. Empty: they
/// agree. Takes as long as clipping once with every algorithm. When a stop is requested, the
/// result is of no use.
std::vector<Disagreement> disagreements(const SceneLines& lines, const clipping::Window& window,
                                        const Variant& chosen, const std::stop_token& stop = {});

/// "All algorithms, corrected, agree here", or "KWC as published loses 456 lines that are visible".
QString sentence(std::span<const Disagreement> disagreements);

} // namespace app
