// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <set>
#include <string>

namespace app::dxf::writing {

/// Makes names of layers legal and different, whatever the case of their letters. In the code page
/// ANSI_1252 of R2000 ä is a byte, and ≤ is \U+2264. R12 has only ASCII: ä becomes a, and ≤ an
/// underscore.
class LayerNames {
public:
    explicit LayerNames(DxfVersion version) : version_(version) {}

    /// The encoded name, without the characters that DXF reserves; with a number if another one
    /// has it.
    std::string legal(const QString& name);

private:
    DxfVersion version_;
    std::set<QString> taken_;
};

} // namespace app::dxf::writing
