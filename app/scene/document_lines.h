// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/scene/scene_lines.h"

namespace app {

/// The visible lines of a document. Curves are flattened to 0.05 mm on paper.
SceneLines linesOf(const Document& document);

} // namespace app
