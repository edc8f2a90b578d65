// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/scene/scene_lines.h"

#include <optional>

namespace app {

/// The topmost editable filled object whose area contains the point. `lines` are the document's
/// lines. Visits the boxes of all chunks, but only few lines.
std::optional<std::size_t> areaAt(const Document& document, const SceneLines& lines,
                                  const Point& point);

} // namespace app
