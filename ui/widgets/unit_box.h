// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/widgets/tool_list.h"

namespace ui {

/// The unit in which the window shows lengths.
class UnitBox : public ToolList {
    Q_OBJECT

public:
    explicit UnitBox(app::Session& session, QWidget* parent = nullptr);
};

/// The selectable units, in menu order.
std::vector<app::Unit> shownUnits();

} // namespace ui
