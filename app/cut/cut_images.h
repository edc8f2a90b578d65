// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

namespace app {

/// Cuts the images of layers, too, at the rectangle around the windows (app/scene/kept_box.h).
void cutImages(Cut& cut, const Document& document, const CutOptions& options);

} // namespace app
