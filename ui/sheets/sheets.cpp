// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/sheets.h"

#include "app/base/text.h"
#include "ui/sheets/page_sheet.h"
#include "ui/bars/status_bar.h"
#include "ui/export/export_sheet.h"
#include "ui/export/print_sheet.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
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

PrintSheet* printSheet(MainWindow& window)
{
    window.status().showHint(Text::tr("Drag to move the preview. Enter: print. Esc: back to the "
                                      "drawing, nothing is changed."));
    auto* sheet = new PrintSheet(window.session(), window.files());
    QObject::connect(sheet, &PrintSheet::summed, &window.status(), &StatusBar::setSummary);
    return sheet;
}

Sheet* makePrint(MainWindow& window) { return printSheet(window); }

Sheet* makeExport(MainWindow& window)
{
    auto* sheet = new ExportSheet(window.session(), window.files());
    QObject::connect(sheet, &ExportSheet::summed, &window.status(), &StatusBar::setSummary);
    QObject::connect(sheet, &ExportSheet::printWanted, &window,
                     [&window](const app::ExportArea& area) {
                         PrintSheet* print = printSheet(window);
                         print->choose(area);
                         window.showSheet(print);
                     });
    window.status().showHint(Text::tr("Drag to move the preview. Enter: export. Esc: back to the "
                                      "drawing, nothing is changed."));
    return sheet;
}

} // namespace

// THE CATALOGUE. To add a sheet: add its row, and the row of its command in a menu.
std::span<const SheetInfo> sheets()
{
    static constexpr std::array all{
        SheetInfo{"page", make<PageSheet>}, SheetInfo{"settings", make<SettingsSheet>},
        SheetInfo{"export", makeExport}, SheetInfo{"print", makePrint}};
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
