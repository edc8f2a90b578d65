// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/session.h"

namespace app {

/// A line of the drawing under the microscope, with what clips and the clip window.
Specimen specimenOf(const Session& session, std::size_t segment);

/// What to look at first: the line in the inspector, else the first that the window cuts, else any;
/// of an empty drawing one of our own.
Specimen firstSpecimen(const Session& session);

} // namespace app
