// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/dash_patterns.h"

#include <QIcon>

namespace ui {

QIcon dashIcon(const app::DashPattern& pattern); ///< of 36 × 12 logical pixels

} // namespace ui
