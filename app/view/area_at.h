// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/scene/scene_lines.h"

#include <optional>

namespace app {

/// The uppermost filled object of those that can be edited whose area the point is in. `lines` are
/// those of the document. It looks at the boxes of all chunks, and at few lines.
std::optional<std::size_t> areaAt(const Document& document, const SceneLines& lines,
                                  const Point& point);

} // namespace app
