// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/rearrange_selection.h"
#include "app/session/units.h"
#include "ui/menus/needs.h"
#include "ui/menus/object_rows.h"
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
            .text = ObjectMenu::tr("&Group"),
            .keys = {K("Ctrl+G")},
            .run = [](MainWindow& w) { app::groupSelection(w.session()); },
            .enabled = someSelected,
            .needs = ObjectMenu::tr("Nothing is selected. Select an object first."),
        },
        {
            .key = "ungroup",
            .text = ObjectMenu::tr("&Ungroup"),
            .keys = {K("Ctrl+Shift+G")},
            .run = [](MainWindow& w) { app::ungroupSelection(w.session()); },
            .enabled = groupSelected,
            .needs = ObjectMenu::tr("No group is selected. Click a group first."),
        },
        {
            .key = "enter-group",
            .text = ObjectMenu::tr("&Enter group"),
            .keys = {K("Ctrl+Return")},
            .run =
                [](MainWindow& w) {
                    const auto groups = app::selectedGroups(w.session());
                    if (groups.empty())
                        emit w.session().refused(
                            ObjectMenu::tr("No group is selected. Click a group first."));
                    else
                        enterGroupAt(w.session(),
                                     w.session().now().containers().rangeOf(groups.back()).first);
                },
            .enabled = groupSelected,
            .needs = ObjectMenu::tr("No group is selected. Click a group first."),
        },
        {
            .key = "leave-group",
            .text = ObjectMenu::tr("Leave group"),
            .keys = {K("Ctrl+Shift+Return")},
            .run = [](MainWindow& w) { leaveGroup(w.session()); },
            .enabled = [](const MainWindow& w) { return w.session().entered.id() != 0; },
            .needs = ObjectMenu::tr("No group is entered. Double click a group to enter it."),
        },
    };
}

} // namespace ui
