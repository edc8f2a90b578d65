// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/typing.h"

namespace ui {

/// Where the pointer aims: at what it snaps to, in steps with Shift, held at what is typed.
class Aim {
public:
    Aim(const HeldTool& held, const Typing& typing) : held_(held), typing_(typing) {}

    /// What the pointer snapped to last, for the marker.
    const std::optional<app::Snap>& snapped() const { return snap_; }
    void forget() { snap_.reset(); } ///< it may no longer exist
    Pointer at(const QPointF& screen, Qt::MouseButtons buttons = {},
               Qt::KeyboardModifiers modifiers = {});
    /// The same for what no tool drags.
    Pointer withoutTool(const QPointF& screen, Qt::KeyboardModifiers modifiers);

private:
    app::SnapQuery query(const app::Point& raw) const;
    app::SnapQuery queryOfTool(const app::Point& raw) const;
    Pointer snapped(const QPointF& screen, const app::SnapQuery& query, Qt::MouseButtons buttons,
                    Qt::KeyboardModifiers modifiers);

    const HeldTool& held_;
    const Typing& typing_;
    std::optional<app::Snap> snap_;
};

} // namespace ui
