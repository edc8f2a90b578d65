// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

namespace ui {

class MainWindow;

/// The drawings that are open, each in a window of its own, one of which is shown. A window that
/// has none of it is alone.
class Drawings {
public:
    virtual ~Drawings() = default;

    virtual int count() const = 0;
    virtual void showWindow(MainWindow& window) = 0;
    virtual void showNext(int by) = 0; ///< in a circle
    /// A further, empty drawing, which is shown; null: no more can be open, which is told.
    virtual MainWindow* addEmpty() = 0;
    /// Closes the drawing of a window, after a question about unsaved changes.
    virtual void close(MainWindow& window) = 0;
    virtual void reopen() = 0; ///< the file that was closed last
    virtual bool canReopen() const = 0;
    /// Objects of this drawing are dragged; true: they are over the tab of another one. Dropped
    /// there they are copied to it, or moved with Shift.
    virtual bool carry(MainWindow& from, const Canvas::Carried& carried) = 0;
};

} // namespace ui
