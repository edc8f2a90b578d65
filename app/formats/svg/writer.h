// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::svg {

/// Writes a document so that read() gives an equal one, bit for bit (unless the precision is
/// limited): layers as Inkscape's, runs of objects of one style in a group that carries the style,
/// the clip window in the metadata. Nothing, or the sentence that says what went wrong.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

/// The same with one more shape, as the last of its layer.
std::optional<QString> writeWith(const Shape& added, const Document& document, QIODevice& out,
                                 const WriteOptions& options);

} // namespace app::svg
