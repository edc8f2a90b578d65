// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// A line of the drawing under the microscope, with what clips and the clip window.
Specimen specimenOf(const Session& session, std::size_t segment);

/// The line to look at first: the one in the inspector, else the first that the window cuts at both
/// ends, else the longest that it cuts at one, else any. Lines of locked layers, such as a grid,
/// come last. Nothing: the drawing is empty.
std::optional<std::size_t> firstLine(const Session& session);
/// What to look at first; of an empty drawing a line of our own.
Specimen firstSpecimen(const Session& session);

} // namespace app
