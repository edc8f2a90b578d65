// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCoreApplication>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ViewMenu", text); }

void toggle(MainWindow& window, bool app::Display::*member)
{
    app::Display display = window.session().display();
    display.*member = !(display.*member);
    window.session().setDisplay(display);
}

/// Zooms the drawing, or the microscope if it is open.
template <int over, int under>
void zoom(MainWindow& window)
{
    constexpr double factor = double(over) / under;
    if (window.session().microscope.isOpen())
        window.microscopePage()->view().zoomBy(factor);
    else
        window.canvas().zoomBy(factor);
}

void addThemes(MainWindow& window, QMenu& menu)
{
    auto* group = new QActionGroup(&menu);
    const std::pair<Theme, QString> themes[]{{Theme::System, tr("As the &desktop")},
                                             {Theme::Light, tr("&Light")},
                                             {Theme::Dark, tr("D&ark")}};
    for (const auto& [theme, text] : themes) {
        QAction* action =
            menu.addAction(text, &window, [&window, theme = theme] { window.setTheme(theme); });
        action->setObjectName(QStringLiteral("theme-%1").arg(int(theme)));
        action->setCheckable(true);
        action->setChecked(window.theme() == theme);
        group->addAction(action);
    }
}

/// Inserts theme and panels before "Presentation".
void complete(MainWindow& window, QMenu& menu)
{
    QAction* before = nullptr;
    for (QAction* action : menu.actions())
        if (action->objectName() == QStringLiteral("presentation"))
            before = action;
    auto* themes = new QMenu(tr("T&heme"), &menu);
    addThemes(window, *themes);
    auto* panels = new QMenu(tr("Pane&ls"), &menu);
    for (QAction* toggle : window.panelToggles())
        panels->addAction(toggle);
    menu.insertMenu(before, themes);
    menu.insertMenu(before, panels);
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo viewMenu()
{
    using K = QKeySequence;
    return {tr("&View"),
            {
                {"zoom-in",
                 tr("Zoom &in"),
                 keys(K::ZoomIn, {K("Ctrl+=")}),
                 Reach::Window,
                 {},
                 zoom<5, 4>},
                {"zoom-out", tr("Zoom &out"), keys(K::ZoomOut), Reach::Window, {}, zoom<4, 5>},
                {"zoom-100",
                 tr("&Actual size"),
                 {K("Ctrl+0")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.canvas().setZoom(1); }},
                {"fit-drawing",
                 tr("&Fit drawing"),
                 {K("Shift+1")},
                 Reach::Canvas,
                 {},
                 [](MainWindow& w) { w.canvas().fitDrawing(); }},
                {"fit-selection",
                 tr("Fit &selection"),
                 {K("Shift+2")},
                 Reach::Canvas,
                 {},
                 [](MainWindow& w) { w.canvas().fitSelection(); },
                 [](const MainWindow& w) { return !w.session().selection().empty(); }},
                {"fit-window",
                 tr("Fit clip &window"),
                 {K("Shift+3")},
                 Reach::Canvas,
                 {},
                 [](MainWindow& w) { w.canvas().fitWindow(); },
                 [](const MainWindow& w) { return w.session().clipWindow().has_value(); },
                 nullptr,
                 {},
                 tr("There is no clip window. Draw one first (W).")},
                {"previous-view",
                 tr("&Previous view"),
                 {K("`")},
                 Reach::Canvas,
                 {},
                 [](MainWindow& w) { w.canvas().previousView(); }},
                {"next-view",
                 tr("&Next view"),
                 {K("~")},
                 Reach::Canvas,
                 {},
                 [](MainWindow& w) { w.canvas().nextView(); }},
                {},
                {"as-printed",
                 tr("Show colours as prin&ted"),
                 {},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { toggle(w, &app::Display::asPrinted); },
                 nullptr,
                 [](const MainWindow& w) { return w.session().display().asPrinted; }},
                {},
                {"presentation",
                 tr("Pres&entation"),
                 {K("F11")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.togglePresenting(); },
                 nullptr,
                 [](const MainWindow& w) { return w.isPresenting(); }},
                {"full-screen",
                 tr("F&ull screen"),
                 {K("Shift+F11")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.setWindowState(w.windowState() ^ Qt::WindowFullScreen); },
                 nullptr,
                 [](const MainWindow& w) { return w.isFullScreen(); }},
                {"reset-layout",
                 tr("Reset la&yout"),
                 {},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.resetLayout(); }},
            },
            complete};
}

} // namespace ui
