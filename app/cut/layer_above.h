// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The container tree with a new empty layer above all others, and its id. If the document can have
/// no further layer: the tree as it is, and the topmost layer.
std::pair<Containers, ContainerId> withLayerAbove(const Document& document, const QString& name);

} // namespace app
