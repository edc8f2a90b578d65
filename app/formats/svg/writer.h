// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::svg {

/// Writes a document so that read() gives an equal one, bit for bit (unless the precision is
/// limited): layers as Inkscape's, groups as <g>, runs of objects of one style in an anonymous <g>
/// that carries the style, the clip windows in the metadata. Nothing, or the sentence that says
/// what went wrong.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::svg
