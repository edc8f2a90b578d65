// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::svg {

/// Writes a document so that read() returns an equal one, bit for bit (unless the precision is
/// limited). Layers are written as Inkscape's layers, groups as <g>, consecutive objects of one
/// style inside an anonymous <g> with that style, and the clip windows in the metadata. Returns
/// nothing, or a sentence that says what went wrong.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::svg
