// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

// Between documents and the plain sheets that were there before them.

namespace app {

/// The same drawing as a document. Its layers follow each other on the first level; its clip window
/// is the only one, a rectangle without a name, and its inside is kept.
Document documentOf(const Sheet& sheet);

/// What a sheet can hold of a document; all of it if it came from one.
/// - Layers in layers become layers that follow each other, hidden or locked where one around them
///   is. One whose objects are interrupted by those of another becomes several: "Roads",
///   "Roads (2)", of which the first has the id.
/// - Groups dissolve. Objects of hidden ones are hidden; whether one was locked is lost.
/// - The clip window is `comparedWindow`'s.
/// - Titles, descriptions and recipes of objects and layers are lost.
Sheet sheetOf(const Document& document);

} // namespace app
