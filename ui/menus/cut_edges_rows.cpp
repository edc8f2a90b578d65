// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

// What the panel Cut edges chooses.

namespace ui {

namespace {

ActionInfo choiceRow(std::string_view key, const QString& text, bool app::CutChoices::*choice)
{
    return {
        .key = key,
        .text = text,
        .run =
            [choice](MainWindow& w) {
                w.session().changeDisplay([choice](app::Display& display) {
                    display.cutting.*choice = !(display.cutting.*choice);
                });
            },
        .checked = [choice](const MainWindow& w) { return w.session().display().cutting.*choice; },
    };
}

} // namespace

std::vector<ActionInfo> cutEdgesRows()
{
    return {
        choiceRow("close-cut-areas", Text::tr("&Close cut areas"), &app::CutChoices::closeAreas),
        choiceRow("cut-hidden", Text::tr("Cut &hidden objects"), &app::CutChoices::cutHidden),
        {
            .key = "drop-pieces",
            .text = Text::tr("&Drop pieces below…"),
            .run =
                [](MainWindow& w) {
                    w.raisePanel(QStringLiteral("cut-edges"));
                    w.findChild<QWidget*>(QStringLiteral("least-piece"))->setFocus();
                },
        },
    };
}

} // namespace ui
