// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"
#include "ui/look/look_icon.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("FileMenu", text); }

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
    auto* forget = menu.addAction(tr("&Clear recent files"), &window.files(), &Files::forgetRecent);
    forget->setEnabled(number > 1);
}

/// Inserts "Open recent" after "Open…".
void complete(MainWindow& window, QMenu& menu)
{
    auto* recent = new QMenu(tr("Open &recent"), &menu);
    recent->setToolTipsVisible(true);
    QObject::connect(recent, &QMenu::aboutToShow, recent,
                     [&window, recent] { fillRecent(window, *recent); });
    menu.insertMenu(menu.actions().value(2), recent);
}

} // namespace

MenuInfo fileMenu()
{
    using K = QKeySequence;
    return {tr("&File"),
            {
                {"new", tr("&New"), keys(K::New), Reach::Window, "page",
                 [](MainWindow& w) { w.files().startNew(); }},
                {"open", tr("&Open…"), keys(K::Open), Reach::Window, "folder",
                 [](MainWindow& w) { w.files().open(); }},
                {},
                {"save",
                 tr("&Save"),
                 keys(K::Save),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.files().save(); }},
                {"save-as",
                 tr("Save &as…"),
                 keys(K::SaveAs, {K("Ctrl+Shift+S")}),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.files().saveAs(); }},
                {},
                {"export",
                 tr("&Export cut drawing…"),
                 {K("Ctrl+E")},
                 Reach::Window,
                 "export",
                 [](MainWindow& w) { w.files().exportCut(); },
                 [](const MainWindow& w) { return w.session().scene.lines().size() > 0; }},
                {},
                {"close",
                 tr("&Close"),
                 {K("Ctrl+W")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.close(); }},
                {"quit",
                 tr("&Quit"),
                 keys(K::Quit, {K("Ctrl+Q")}),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.close(); }},
            },
            complete};
}

} // namespace ui
