// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/rearrange_selection.h"
#include "app/session/units.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/tools/group_choice.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

bool groupSelected(const MainWindow& window) { return app::someGroupSelected(window.session()); }

} // namespace

std::vector<ActionInfo> groupRows()
{
    using K = QKeySequence;
    return {
        {
            .key = "group",
            .text = Text::tr("&Group"),
            .keys = {K("Ctrl+G")},
            .run = [](MainWindow& w) { app::groupSelection(w.session()); },
            .enabled = someSelected,
            .needs = Text::tr("Nothing is selected. Select an object first."),
        },
        {
            .key = "ungroup",
            .text = Text::tr("&Ungroup"),
            .keys = {K("Ctrl+Shift+G")},
            .run = [](MainWindow& w) { app::ungroupSelection(w.session()); },
            .enabled = groupSelected,
            .needs = Text::tr("No group is selected. Click a group first."),
        },
        {
            .key = "enter-group",
            .text = Text::tr("&Enter group"),
            .keys = {K("Ctrl+Return")},
            .run =
                [](MainWindow& w) {
                    const auto groups = app::selectedGroups(w.session());
                    if (groups.empty())
                        emit w.session().refused(
                            Text::tr("No group is selected. Click a group first."));
                    else
                        enterGroupAt(w.session(),
                                     w.session().now().containers().rangeOf(groups.back()).first);
                },
            .enabled = groupSelected,
            .needs = Text::tr("No group is selected. Click a group first."),
        },
        {
            .key = "leave-group",
            .text = Text::tr("Leave group"),
            .keys = {K("Ctrl+Shift+Return")},
            .run = [](MainWindow& w) { leaveGroup(w.session()); },
            .enabled = [](const MainWindow& w) { return w.session().entered.id() != 0; },
            .needs = Text::tr("No group is entered. Double click a group to enter it."),
        },
    };
}

} // namespace ui
