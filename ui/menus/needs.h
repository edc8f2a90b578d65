// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace ui {

class MainWindow;

/// Whether a command on the selection is enabled.
bool someSelected(const MainWindow& window);

/// Why a command on the selection is disabled.
QString nothingSelected();

} // namespace ui
