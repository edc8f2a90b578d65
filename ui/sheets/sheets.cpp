// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/sheets.h"

#include "app/base/text.h"
#include "ui/sheets/page_sheet.h"
#include "ui/sheets/settings_sheet.h"
#include "ui/window/main_window.h"

#include <algorithm>
#include <array>

namespace ui {

namespace {

template <class Shown>
Sheet* make(MainWindow& window)
{
    return new Shown(window);
}

} // namespace

// THE CATALOGUE. To add a sheet: add its row, and the row of its command in a menu.
std::span<const SheetInfo> sheets()
{
    static constexpr std::array all{SheetInfo{"page", make<PageSheet>},
                                    SheetInfo{"settings", make<SettingsSheet>}};
    return all;
}

void showSheet(MainWindow& window, std::string_view key)
{
    const auto row = std::ranges::find(sheets(), key, &SheetInfo::key);
    if (row == sheets().end())
        return;
    if (Sheet* shown = window.sheet(); shown && shown->objectName() == app::latin(key))
        shown->focusFirst();
    else
        window.showSheet(row->make(window));
}

} // namespace ui
