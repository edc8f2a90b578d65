// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// The rectangle at which the microscope clips lines of the drawing: the window in hand if it is a
/// rectangle, also a rotated one, else `Session::window`. A line is traced in the rectangle's own
/// directions, in which it is along the axes, with the numbers of the panel *Clip window*.
struct TracedWindow {
    WindowFrame frame;
    bool isPage = false;
    /// The name of the window in hand if it has another shape, so that another rectangle is used.
    std::optional<QString> notAt{};

    clipping::Segment into(const clipping::Segment& line) const;
    /// Says which rectangle it is, to follow "Line 217 of 420"; empty for one along the axes.
    QString remark() const;
};
TracedWindow tracedWindow(const Session& session);

} // namespace app
