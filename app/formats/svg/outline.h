// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/path_data.h"
#include "app/formats/svg/style.h"

namespace app::svg {

/// One row of the table of SVG's basic shapes: <rect>, <circle> ... <path>.
struct OutlineKind {
    std::string_view element;
    /// In the element's own coordinates.
    Outline (*outline)(const Tree&, Node, const Properties&, const Lengths&);
};
const OutlineKind* findOutlineKind(std::string_view element); ///< null: not a basic shape

} // namespace app::svg
