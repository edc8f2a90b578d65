// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

namespace app {

/// Adds `outside`, the drawing with only the parts outside the clip windows, to an edit that leaves
/// the parts inside. Above each layer of the first level that has objects outside there is then a
/// layer "Roads, outside" with the same inner layers and groups, so that the painting order stays.
/// Of these, those with an id that the parts inside have get a numbered one. Empty if the document
/// can have no such layers.
std::optional<Edit> withOutsideLayers(const Document& document, const Edit& inside,
                                      const Document& outside);

} // namespace app
