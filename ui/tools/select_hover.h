// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/end_drag.h"
#include "ui/tools/pivot_marks.h"

namespace ui {

/// The frame of the selection, with handles; a single line shows its ends instead.
std::optional<app::WindowFrame> handledFrame(const app::Session& session);

/// What lies under the pointer of the tool Select, and would be dragged by a press.
struct SelectHover {
    std::optional<app::Handle> window; ///< a handle of the clip window
    std::optional<EndDrag::End> end;   ///< of the inspected line
    PivotMarks::Mark mark = PivotMarks::Mark::None;
    std::optional<app::Handle> box;     ///< of the selection's frame
    std::optional<std::size_t> segment; ///< of the scene
    std::optional<std::size_t> guide;
    bool near = false; ///< the pointer is near the selection

    bool isHandle() const { return window || end || guide; } ///< whose drag begins with the press
    void look(const Pointer& pointer, const Workbench& bench);
    void lookNear(const Pointer& pointer, const Workbench& bench);
    QCursor cursor(const app::Session& session) const;
    QString hint(const Workbench& bench) const; ///< empty: nothing of it is there
};

} // namespace ui
