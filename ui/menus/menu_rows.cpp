// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/menu_rows.h"

#include "ui/look/text.h"
#include "ui/tools/tool.h"
#include "ui/window/main_window.h"

namespace ui {

std::vector<ActionInfo> toolRows(const std::vector<std::string_view>& keys)
{
    std::vector<ActionInfo> rows;
    for (const std::string_view key : keys)
        rows.push_back({.text = findTool(key)->name, .tool = key});
    return rows;
}

std::vector<ActionInfo> joined(const std::vector<std::vector<ActionInfo>>& parts)
{
    std::vector<ActionInfo> all;
    for (const std::vector<ActionInfo>& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::vector<ActionInfo> inSubmenu(const QString& title,
                                  const std::vector<std::vector<ActionInfo>>& parts)
{
    std::vector<ActionInfo> all = joined(parts);
    for (ActionInfo& row : all)
        row.submenu = title;
    return all;
}

void showIfUnseen(Canvas& canvas, const std::optional<clipping::Window>& box, void (Canvas::*fit)())
{
    const clipping::Window seen = canvas.view().visible();
    if (box
        && (box->max.x < seen.min.x || box->min.x > seen.max.x || box->max.y < seen.min.y
            || box->min.y > seen.max.y))
        (canvas.*fit)();
}

bool someLines(const MainWindow& window) { return window.session().scene.lines().size() > 0; }

bool someSelected(const MainWindow& window) { return !window.session().selection().empty(); }

QString nothingSelected() { return Text::tr("Nothing is selected. Select an object first."); }

} // namespace ui
