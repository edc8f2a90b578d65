// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

// Where the algorithms of an open drawing are compared, in words.

/// The name of the clip window, if it does not alone decide what of the drawing is kept: then the
/// numbers of a comparison are not those of the picture. Empty otherwise.
QString comparedName(const Session& session);

/// For captions: that nothing is compared, and why; that the drawing is compared at the page, or
/// inside one of its clip windows. Empty if that is the only one.
QString comparedText(const Session& session);

} // namespace app
