// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/text.h"

namespace ui {

using app::Text; ///< rather than a widget's own tr(), which would open a context for each class

} // namespace ui
