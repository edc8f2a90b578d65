// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/sheet.h"

namespace ui {

class KeyboardPage;
class MainWindow;
class Segments;
class SettingsPage;

/// All settings of the program in one place: a page of settings, and one of the commands' keys.
/// Each takes effect at once.
class SettingsSheet : public Sheet {
    Q_OBJECT

public:
    enum Page : std::uint8_t { General, Keyboard };
    explicit SettingsSheet(MainWindow& window);

    void turnTo(int page);

private:
    Segments* pages_;
    SettingsPage* general_;
    KeyboardPage* keyboard_;
    QPushButton* reset_;
};

} // namespace ui
