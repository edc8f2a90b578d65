// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"
#include "ui/bars/option_bar.h"
#include "ui/editing/editing.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/properties/style_panel.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QStatusBar>

namespace ui {

namespace {

/// Goes to the panel, or opens it below its button.
void openStyle(MainWindow& window)
{
    if (!window.showsPanel("properties"))
        return window.optionBar().openStyle();
    window.raisePanel("properties");
    for (StylePanel* panel : window.findChildren<StylePanel*>())
        if (panel->isVisible())
            panel->focusFirst();
}

ActionInfo takeColour(std::string_view key, const QString& text, const char* shortcut,
                      app::PaintPart part)
{
    return {
        .key = key,
        .text = text,
        .keys = {QKeySequence(shortcut)},
        .scope = ShortcutScope::Canvas,
        .run = [part](MainWindow& w) { w.optionBar().takeColour(part); },
    };
}

} // namespace

std::vector<ActionInfo> styleRows()
{
    using K = QKeySequence;
    return {
        {
            .key = "style",
            .text = Text::tr("&Style…"),
            .keys = {K("Ctrl+Shift+F")},
            .icon = "style",
            .run = openStyle,
            .made = [](MainWindow& w, QAction& action) { w.optionBar().setStyleCommand(action); },
        },
        takeColour("take-stroke", Text::tr("&Take stroke colour from the drawing"), "I",
                   &app::Style::stroke),
        takeColour("take-fill", Text::tr("Take &fill colour from the drawing"), "Shift+I",
                   &app::Style::fill),
        {},
        {
            .key = "copy-style",
            .text = Text::tr("&Copy style"),
            .keys = {K("Ctrl+Shift+C")},
            .run =
                [](MainWindow& w) {
                    copyStyle(w.session());
                    w.refreshActions();
                    w.statusBar()->showMessage(
                        app::withKeys(Text::tr("The style is copied. Select other objects and "
                                               "paste it ({paste-style}).")),
                        MainWindow::messageMilliseconds);
                },
        },
        {
            .key = "paste-style",
            .text = Text::tr("&Paste style"),
            .keys = {K("Ctrl+Shift+V")},
            .run = [](MainWindow& w) { pasteStyle(w.session()); },
            .enabled = [](const MainWindow&) { return hasCopiedStyle(); },
            .needs = Text::tr("No style was copied. Select an object and copy its style first."),
        },
    };
}

} // namespace ui
