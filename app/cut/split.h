// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

namespace app {

/// Divides the objects at the clip windows, whichever side these keep. What is inside stays in its
/// layer and group. What is outside goes to a layer of its own above each layer, "Roads, outside",
/// with the same inner layers and groups (outside_layers.h); if the document can have no such
/// layers, to one layer above all others. In the counts, `whole` includes objects that are wholly
/// outside. When a stop is requested, the result is of no use.
Cut split(const Document& document, const CutOptions& options, const Follower& follower = {});

} // namespace app
