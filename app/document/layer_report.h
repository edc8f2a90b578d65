// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/session.h"

namespace app {

/// How many of the scene's lines are on a layer; none if it is hidden.
std::size_t linesOfLayer(const Session& session, std::uint32_t layer);

/// The ink that stands for a layer: that of its first shape with one.
std::optional<Colour> inkOfLayer(const Sheet& sheet, std::uint32_t layer);

} // namespace app
