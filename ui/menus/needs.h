// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace ui {

/// Why a command on the selection is disabled.
QString nothingSelected();

} // namespace ui
