// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/session/session.h"

namespace app {

/// The stroke colour that the layer gives to new objects; empty: it leaves that to the pen.
std::optional<Colour> layerColour(const Document& document, ContainerId layer);
/// Gives the layer a colour as one undo step. New objects keep the rest of the layer's style, or of
/// the pen's. Without a colour, the layer leaves the whole style to the pen.
void setLayerColour(Session& session, ContainerId layer, const std::optional<Colour>& colour);

/// The colour that represents a container: that of its first object with a stroke or fill. It is
/// computed after every edit, so only some thousand styles are examined: objects of one style that
/// share a block count once.
std::optional<Colour> strokeColourOf(const Document& document, ContainerId container);

} // namespace app
