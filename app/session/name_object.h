// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// Gives an object a name, as one undoable step. A name is an id in SVG: blanks become "_", and
/// each stands once in a drawing. If it cannot have it, `Session::refused` says why. Returns
/// whether it was changed.
bool nameObject(Session& session, std::size_t object, const QString& typed);

} // namespace app
