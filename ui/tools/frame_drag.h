// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/typed_entry.h"
#include "app/view/frame_handles.h"

#include <Qt>

namespace ui {

/// A handle of a frame that is dragged, as of a clip window or of the selection: with Shift in
/// proportion, with Alt about the centre. The places are of before the drag, in the drawing.
struct HeldHandle {
    app::Handle handle;
    app::WindowFrame frame;

    app::Point place() const;
    app::Point fixed(Qt::KeyboardModifiers modifiers) const; ///< the point that stays
    const app::GestureMeasure& measure(Qt::KeyboardModifiers modifiers) const;
    app::GestureStart start(Qt::KeyboardModifiers modifiers) const; ///< of the measure
};

} // namespace ui
