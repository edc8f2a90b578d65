// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edit.h"

namespace app {

class Document;

/// Writes all texts in outlines again in the first font of single strokes: as high as before or
/// smaller, so that they are not longer, and in the middle of their places. Their fill becomes the
/// colour of their strokes.
Edit textsAsStrokes(const Document& document);

} // namespace app
