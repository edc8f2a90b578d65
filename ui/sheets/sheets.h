// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace ui {

class MainWindow;
class Sheet;

/// A sheet that can stand at the right of the window. Its key is the objectName of the sheet.
struct SheetInfo {
    std::string_view key;
    Sheet* (*make)(MainWindow& window);
};

/// All of them.
std::span<const SheetInfo> sheets();

/// Shows this sheet; if it is shown already, it gets the focus.
void showSheet(MainWindow& window, std::string_view key);

} // namespace ui
