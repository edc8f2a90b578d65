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
    window.session().changeDisplay(
        [member](app::Display& display) { display.*member = !(display.*member); });
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

void addPanels(MainWindow& window, QMenu& menu) { menu.addActions(window.panelToggles()); }

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo viewMenu()
{
    using K = QKeySequence;
    return {
        .title = tr("&View"),
        .rows =
            {
                {
                    .key = "zoom-in",
                    .text = tr("Zoom &in"),
                    .keys = keys(K::ZoomIn, {K("Ctrl+=")}),
                    .run = zoom<5, 4>,
                },
                {
                    .key = "zoom-out",
                    .text = tr("Zoom &out"),
                    .keys = keys(K::ZoomOut),
                    .run = zoom<4, 5>,
                },
                {
                    .key = "zoom-100",
                    .text = tr("&Actual size"),
                    .keys = {K("Ctrl+0")},
                    .run = [](MainWindow& w) { w.canvas().setZoom(1); },
                },
                {
                    .key = "fit-drawing",
                    .text = tr("&Fit drawing"),
                    .keys = {K("Shift+1")},
                    .scope = ShortcutScope::Canvas,
                    .run = [](MainWindow& w) { w.canvas().fitDrawing(); },
                },
                {
                    .key = "fit-selection",
                    .text = tr("Fit &selection"),
                    .keys = {K("Shift+2")},
                    .scope = ShortcutScope::Canvas,
                    .run = [](MainWindow& w) { w.canvas().fitSelection(); },
                    .enabled = [](const MainWindow& w) { return !w.session().selection().empty(); },
                },
                {
                    .key = "fit-window",
                    .text = tr("Fit clip &window"),
                    .keys = {K("Shift+3")},
                    .scope = ShortcutScope::Canvas,
                    .run = [](MainWindow& w) { w.canvas().fitWindow(); },
                    .enabled =
                        [](const MainWindow& w) { return w.session().clipWindow().has_value(); },
                    .needs = tr("There is no clip window. Draw one first (W)."),
                },
                {
                    .key = "previous-view",
                    .text = tr("&Previous view"),
                    .keys = {K("`")},
                    .scope = ShortcutScope::Canvas,
                    .run = [](MainWindow& w) { w.canvas().previousView(); },
                },
                {
                    .key = "next-view",
                    .text = tr("&Next view"),
                    .keys = {K("~")},
                    .scope = ShortcutScope::Canvas,
                    .run = [](MainWindow& w) { w.canvas().nextView(); },
                },
                {},
                {
                    .key = "snap",
                    .text = tr("Snappin&g"),
                    .keys = {K("F5")},
                    .run = [](MainWindow& w) { w.canvas().switchSnapping(!w.canvas().snaps()); },
                    .checked = [](const MainWindow& w) { return w.canvas().snaps(); },
                },
                {
                    .key = "as-printed",
                    .text = tr("Show colours as prin&ted"),
                    .run = [](MainWindow& w) { toggle(w, &app::Display::asPrinted); },
                    .checked = [](const MainWindow& w) { return w.session().display().asPrinted; },
                },
                {},
                {
                    .text = tr("T&heme"),
                    .fill = addThemes,
                },
                {
                    .text = tr("Pane&ls"),
                    .fill = addPanels,
                },
                {
                    .key = "presentation",
                    .text = tr("Pres&entation"),
                    .keys = {K("F11")},
                    .run = [](MainWindow& w) { w.togglePresenting(); },
                    .checked = [](const MainWindow& w) { return w.isPresenting(); },
                },
                {
                    .key = "full-screen",
                    .text = tr("F&ull screen"),
                    .keys = {K("Shift+F11")},
                    .run =
                        [](MainWindow& w) {
                            w.setWindowState(w.windowState() ^ Qt::WindowFullScreen);
                        },
                    .checked = [](const MainWindow& w) { return w.isFullScreen(); },
                },
                {
                    .key = "reset-layout",
                    .text = tr("Reset la&yout"),
                    .run = [](MainWindow& w) { w.resetLayout(); },
                },
            },
    };
}

} // namespace ui
