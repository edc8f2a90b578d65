// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/typing.h"

#include <QTimer>

namespace ui {

/// Undo and redo of one step: a corner of the polyline being drawn, else a step of the history.
/// During a drag, undo() cancels the drag and redo() does nothing.
class GestureSteps : public QObject {
    Q_OBJECT

public:
    GestureSteps(HeldTool& held, Typing& typing);

    bool canUndo() const;
    bool canRedo() const;
    void undo();
    void redo();
    void goTo(int index);     ///< a step of the history; ends the gesture
    QString undoText() const; ///< the name of that step
    QString redoText() const;

signals:
    /// The effect of undo() and redo(), or the object being drawn, has changed; for a freehand line
    /// emitted at most every 100 ms.
    void changed();

private:
    /// The part of what changed() reports that a tool can change: after the last call of it.
    struct Known {
        bool undo = false, redo = false, takeBack = false;
        std::size_t points = 0;
        friend bool operator==(const Known&, const Known&) = default;
    };
    Known now() const;
    void follow();

    HeldTool& held_;
    Typing& typing_;
    Known known_;
    QTimer growing_; ///< runs while the object being drawn has points not yet told
};

} // namespace ui
