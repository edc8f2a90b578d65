// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_handles.h"
#include "ui/tools/tool.h"

namespace ui {

/// The box and the handles of selected objects, which never hide them: they lie outside.
class SelectionMarks {
public:
    /// The frame around that of the selection, on which the handles are. In the drawing.
    static app::WindowFrame around(const app::WindowFrame& frame, const Workbench& bench);
    static std::vector<app::PlacedHandle> handles(const app::WindowFrame& around,
                                                  const Workbench& bench);
    /// Whether the pointer is so near that marks which are not always shown are wanted.
    static bool isNear(const app::Point& screen, const app::WindowFrame& frame,
                       const Workbench& bench);
    /// The selected object is a text: a quiet box, until the pointer is near.
    static bool isQuiet(const app::Session& session);
    /// `near`: as isNear() says.
    static void paint(QPainter& painter, const Workbench& bench, const app::WindowFrame& frame,
                      bool near);
};

/// The selection on the screen, and the places of what its marks are made of; there is one. In
/// logical pixels.
QRectF selectionOnScreen(const Workbench& bench);
std::vector<QRectF> selectionMarks(const Workbench& bench);

} // namespace ui
