// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::svg {

/// Writes a document so that read() returns an equal one, bit for bit (unless the precision is
/// limited). Layers are written as Inkscape's layers, groups as <g>, and the clip windows in the
/// metadata. With more than 10,000 objects, consecutive ones of one style are inside an anonymous
/// <g> with that style. Returns nothing, or a sentence that says what went wrong.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

/// The same with a user unit of one pixel around a group that scales the drawing, for programs that
/// ignore any other unit. Clip windows, guides and sheets must not be there.
std::optional<QString> writeInPixels(const Document& document, QIODevice& out,
                                     const WriteOptions& options);

} // namespace app::svg
