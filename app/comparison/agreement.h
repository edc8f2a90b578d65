// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/scene/scene_lines.h"

#include <QString>

#include <span>
#include <vector>

namespace app {

/// What one form of an algorithm does on many segments that is not what most algorithms do.
struct Dissent {
    Variant variant;
    std::size_t lost = 0;  ///< segments that are visible and that it drops
    std::size_t shown = 0; ///< segments that are not visible and that it keeps
    std::size_t moved = 0; ///< visible ones with an end farther off than both rows' ulps allow
    std::vector<std::uint32_t> segments{}; ///< all of these, ascending

    bool none() const { return segments.empty(); }
};

/// The verdict on a drawing and a window: one entry for each corrected form of the catalogue that
/// differs from what the majority of them says, and one for `chosen` in `form` if that is the
/// published one. Empty: they agree. Takes as long as clipping once with every algorithm.
std::vector<Dissent> dissents(const SceneLines& lines, const clipping::Window& window,
                              const Variant& chosen);

/// "All algorithms, corrected, agree here", or "KWC as published loses 456 lines that are visible".
QString sentence(std::span<const Dissent> dissents);

} // namespace app
