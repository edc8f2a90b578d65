// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/scene/scene_lines.h"

namespace app {

/// The lines that a document shows. Curves are flattened to 0.05 mm on paper.
SceneLines linesOf(const Document& document);

} // namespace app
