// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <vector>

namespace ui {

class MainWindow;

/// One setting of the program, with what it may be. Its value is the number of its choice, or 1 and
/// 0 for on and off; -1: a value that is not among the choices.
struct Setting {
    struct Choice {
        QString key; ///< of its command
        QString text;
    };
    QString key; ///< of its command, if it is on or off
    QString text, tip{};
    QString command{};             ///< the text of its command; empty: its own
    std::vector<Choice> choices{}; ///< empty: on or off
    std::function<int(const MainWindow&)> value{};
    std::function<void(MainWindow&, int)> set{}; ///< takes effect at once, and is remembered
    std::function<int(const MainWindow&)> standard{};
    /// Sets the standard where this may be none of the choices; empty: `set` does.
    std::function<void(MainWindow&)> reset{};
    /// Of a part of the setting above it: whether that one is on, so that the part counts. Empty:
    /// it is no part.
    std::function<bool(const MainWindow&)> counts{};
    /// Whether no menu has it: the palette finds its commands anyway.
    bool isOnlyHere = true;
};

/// Settings with a title.
struct SettingsGroup {
    QString title;
    std::vector<Setting> settings;
};

/// All settings but the keys, in the order in which they are shown.
const std::vector<SettingsGroup>& settingsGroups();

/// Sets it, and tells the window; nothing if the value is not among the choices.
void change(const Setting& setting, MainWindow& window, int value);

/// Sets it as it was at first, and tells the window.
void reset(const Setting& setting, MainWindow& window);

} // namespace ui
