// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/sheet.h"

namespace ui {

class MainWindow;

/// All settings of the program in one place. Each takes effect at once.
class SettingsSheet : public Sheet {
    Q_OBJECT

public:
    explicit SettingsSheet(MainWindow& window);
};

} // namespace ui
