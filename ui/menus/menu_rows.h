// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"
#include "ui/menus/actions.h"

#include <QString>

#include <optional>

// Parts of menus.

namespace ui {

class Canvas;
class MainWindow;

std::vector<ActionInfo> groupRows();       ///< group, ungroup, enter, leave
std::vector<ActionInfo> orderRows();       ///< raise, lower
std::vector<ActionInfo> turnRows();        ///< rotate by 90°, flip
std::vector<ActionInfo> arrangementRows(); ///< align, spread, make same size
std::vector<ActionInfo> pathRows();        ///< the steps that edit nodes, outline of stroke
std::vector<ActionInfo> styleRows();       ///< style, eyedropper, copy and paste style
std::vector<ActionInfo> selectRows();      ///< layer, invert, same colour
std::vector<ActionInfo> panesRows();
std::vector<ActionInfo> cutEdgesRows(); ///< what the panel *Cut edges* chooses
ActionInfo moveToLayerRow();
ActionInfo convertRow(); ///< to a path
ActionInfo findRow();

/// Entries of these tools, in the order of the keys.
std::vector<ActionInfo> toolRows(const std::vector<std::string_view>& keys);
/// Joins rows, which may be separators, to those of one submenu.
std::vector<ActionInfo> inSubmenu(const QString& title,
                                  const std::vector<std::vector<ActionInfo>>& parts);
/// Joins the rows of a menu.
std::vector<ActionInfo> joined(const std::vector<std::vector<ActionInfo>>& parts);

/// Fits the view with `fit` if the box is wholly outside it.
void showIfUnseen(Canvas& canvas, const std::optional<clipping::Window>& box,
                  void (Canvas::*fit)());

bool someLines(const MainWindow& window); ///< whether the drawing has any

/// Whether a command on the selection is enabled.
bool someSelected(const MainWindow& window);

/// Why a command on the selection is disabled.
QString nothingSelected();

} // namespace ui
