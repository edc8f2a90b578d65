// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"
#include "ui/files/files.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/sheets/sheets.h"
#include "ui/window/drawings.h"
#include "ui/window/main_window.h"

#include <QFileInfo>
#include <QMenu>

namespace ui {

namespace {

void fillRecent(MainWindow& window, QMenu& menu)
{
    menu.clear();
    int number = 1;
    for (const app::RecentFile& file : window.files().recent()) {
        auto* action = menu.addAction(
            QStringLiteral("&%1  %2").arg(number++ % 10).arg(QFileInfo(file.path).fileName()),
            &window, [&window, path = file.path] { window.files().open(path); });
        action->setToolTip(file.path);
        action->setEnabled(!file.missing());
    }
    menu.addSeparator();
    auto* forget =
        menu.addAction(Text::tr("&Clear recent files"), &window.files(), &Files::forgetRecent);
    forget->setEnabled(number > 1);
}

void addRecent(MainWindow& window, QMenu& menu)
{
    menu.setToolTipsVisible(true);
    QObject::connect(&menu, &QMenu::aboutToShow, &menu,
                     [&window, &menu] { fillRecent(window, menu); });
}

bool severalDrawings(const MainWindow& window)
{
    return window.drawings() && window.drawings()->count() > 1;
}

void addSamples(MainWindow& window, QMenu& menu)
{
    for (const app::Sample& sample : app::samples()) {
        auto* action = menu.addAction(sample.title, &window,
                                      [&window, sample] { window.files().openSample(sample); });
        action->setObjectName(QStringLiteral("sample-") + sample.key);
    }
}

} // namespace

MenuInfo fileMenu()
{
    using K = QKeySequence;
    return {
        .title = Text::tr("&File"),
        .rows =
            {
                {
                    .key = "new",
                    .text = Text::tr("&New"),
                    .keys = keys(K::New),
                    .icon = "page",
                    .run = [](MainWindow& w) { w.files().startNew(); },
                },
                {
                    .key = "open",
                    .text = Text::tr("&Open…"),
                    .keys = keys(K::Open),
                    .icon = "folder",
                    .run = [](MainWindow& w) { w.files().open(); },
                },
                {
                    .text = Text::tr("Open &recent"),
                    .fill = addRecent,
                },
                {
                    .text = Text::tr("Open sa&mple"),
                    .fill = addSamples,
                },
                {},
                {
                    .key = "save",
                    .text = Text::tr("&Save"),
                    .keys = keys(K::Save),
                    .run = [](MainWindow& w) { w.files().save(); },
                },
                {
                    .key = "save-as",
                    .text = Text::tr("Save &as…"),
                    .keys = keys(K::SaveAs, {K("Ctrl+Shift+S")}),
                    .run = [](MainWindow& w) { w.files().saveAs(); },
                },
                {},
                {
                    .key = "page",
                    .text = Text::tr("Pa&ge…"),
                    .keys = {K("Ctrl+Alt+P")},
                    .icon = "page",
                    .run = [](MainWindow& w) { showSheet(w, "page"); },
                },
                {
                    .key = "export",
                    .text = Text::tr("&Export…"),
                    .keys = {K("Ctrl+E")},
                    .icon = "export",
                    .run = [](MainWindow& w) { showSheet(w, "export"); },
                    .enabled = someLines,
                    .made = [](MainWindow& w, QAction& action) { w.optionBar().setExport(action); },
                },
                {
                    .key = "export-again",
                    .text = Text::tr("Export again"),
                    .keys = {K("Ctrl+Shift+E")},
                    .run =
                        [](MainWindow& w) {
                            if (!w.files().exportAgain())
                                showSheet(w, "export");
                        },
                    .enabled = someLines,
                    .paletteOnly = true,
                },
                {
                    .key = "opening-report",
                    .text = Text::tr("What was &changed on opening…"),
                    .run = [](MainWindow& w) { w.files().showLosses(); },
                    .enabled = [](const MainWindow& w) { return !w.session().losses().empty(); },
                    .needs = Text::tr("Nothing was changed or left out when this was opened."),
                    .paletteOnly = true,
                },
                {
                    .key = "print",
                    .text = Text::tr("&Print…"),
                    .keys = keys(K::Print, {K("Ctrl+P")}),
                    .run = [](MainWindow& w) { showSheet(w, "print"); },
                    .enabled = someLines,
                },
                {
                    .key = "settings",
                    .text = Text::tr("Se&ttings…"),
                    .keys = keys(K::Preferences, {K("Ctrl+,")}),
                    .icon = "gear",
                    .run = [](MainWindow& w) { showSheet(w, "settings"); },
                },
                {},
                {
                    .key = "close",
                    .text = Text::tr("&Close"),
                    .keys = {K("Ctrl+W")},
                    .run =
                        [](MainWindow& w) {
                            if (w.drawings())
                                return w.drawings()->close(w);
                            w.files().startNew([&w] { w.raisePanel(QStringLiteral("start")); });
                        },
                },
                {
                    .key = "quit",
                    .text = Text::tr("&Quit"),
                    .keys = keys(K::Quit, {K("Ctrl+Q")}),
                    .run = [](MainWindow& w) { w.window()->close(); },
                },
                {
                    .key = "reopen",
                    .text = Text::tr("&Reopen closed drawing"),
                    .keys = {K("Ctrl+Shift+T")},
                    .run = [](MainWindow& w) { w.drawings()->reopen(); },
                    .enabled =
                        [](const MainWindow& w) {
                            return w.drawings() && w.drawings()->canReopen();
                        },
                    .needs = Text::tr("No file was closed."),
                    .paletteOnly = true,
                },
                {
                    .key = "next-drawing",
                    .text = Text::tr("&Next drawing"),
                    .keys = {K("Ctrl+Tab"), K("Ctrl+PgDown")},
                    .run = [](MainWindow& w) { w.drawings()->showNext(+1); },
                    .enabled = severalDrawings,
                    .needs = Text::tr("Only one drawing is open."),
                    .paletteOnly = true,
                },
                {
                    .key = "previous-drawing",
                    .text = Text::tr("&Previous drawing"),
                    .keys = {K("Ctrl+Shift+Tab"), K("Ctrl+PgUp")},
                    .run = [](MainWindow& w) { w.drawings()->showNext(-1); },
                    .enabled = severalDrawings,
                    .needs = Text::tr("Only one drawing is open."),
                    .paletteOnly = true,
                },
            },
    };
}

} // namespace ui
