// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// How many of the scene's lines are in a container; none if it is hidden.
std::size_t linesOf(const Session& session, ContainerId container);

/// The ink that stands for a container: that of its first object with one. It is asked for at every
/// edit, so only some thousand styles are looked at: objects of one style that share a block count
/// once.
std::optional<Colour> inkOf(const Document& document, ContainerId container);

} // namespace app
