// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The colour that represents a container: that of its first object with a stroke or fill. It is
/// computed after every edit, so only some thousand styles are examined: objects of one style that
/// share a block count once.
std::optional<Colour> strokeColourOf(const Document& document, ContainerId container);

} // namespace app
