// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::dxf::writing {

/// Writes a drawing as a DXF file of the version in `options`: each path as one entity, layers with
/// their colour, y up. Returns nothing, or what went wrong.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::dxf::writing
