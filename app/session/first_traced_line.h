// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// A line of the drawing for the microscope, with its variant and the clip window.
TracedLine tracedLineOf(const Session& session, std::size_t segment);

/// The line to show first: the one in the inspector, otherwise the one that shows most of clipping
/// (line_to_see.h), in a drawing of millions of lines the best of the first ones. Empty: the
/// drawing is empty.
std::optional<std::size_t> firstLine(const Session& session);
/// The traced line to show first; for an empty drawing a built-in example.
TracedLine firstTracedLine(const Session& session);

} // namespace app
