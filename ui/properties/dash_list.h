// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selection_style.h"
#include "ui/widgets/tool_list.h"

#include <span>

namespace ui {

/// The usual dash patterns as pictures. What styles have that is none of them is named.
class DashList : public ToolList {
    Q_OBJECT

public:
    DashList();

    void follow(std::span<const app::Style> styles);

signals:
    /// A pattern was chosen: what it makes of a style.
    void picked(const app::ChangeStyle& pattern);
};

} // namespace ui
