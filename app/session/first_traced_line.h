// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// A line of the drawing for the microscope, with its variant and the clip window.
TracedLine tracedLineOf(const Session& session, std::size_t segment);

/// The line to show first: the one in the inspector, otherwise the first that the window cuts at
/// both ends, otherwise the longest that it cuts at one, otherwise any. Lines of locked layers,
/// such as a grid, come last. Empty: the drawing is empty.
std::optional<std::size_t> firstLine(const Session& session);
/// The traced line to show first; for an empty drawing a built-in example.
TracedLine firstTracedLine(const Session& session);

} // namespace app
