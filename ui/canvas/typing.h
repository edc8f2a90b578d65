// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/readout.h"
#include "ui/canvas/held_tool.h"

#include <QRectF>

namespace ui {

/// The numbers of the held tool's gesture, for as long as its gauge is the same. A person may type
/// them: they hold the pointer, before the tool sees it, and end the gesture exactly.
class Typing : public QObject {
    Q_OBJECT

public:
    explicit Typing(HeldTool& held);

    /// Empty: the tool takes no numbers now.
    const std::optional<app::Readout>& readout() const { return readout_; }
    bool going() const { return going_; } ///< a field of the readout is open
    bool shown() const { return readout_ && (going_ || held_.busy() || readout_->isLocked()); }
    /// Of the gesture, of the finished step, or of the first point of the next gesture.
    bool takesNumbers() const;
    /// Where the pointer would end the gesture, if nothing were typed.
    app::Point aim() const;

    void begin(const QString& first, bool inSecondField = false);
    void type(const QString& text); ///< replaces the text of the active field
    void lock();                    ///< and goes on to the other field
    void release(); ///< gives the active field back to the pointer, and stops typing
    /// Ends the gesture, or its current step, with these numbers. A direction alone is only locked.
    void accept();
    void stop();
    /// Gives the numbers of a gesture that has not begun back to the pointer; false: none are held.
    bool releaseLocked();

    void hold(Pointer& pointer) const; ///< at what is typed
    void steer();  ///< lets the tool follow what is typed, as if the pointer had moved
    void follow(); ///< the tool's gauge

    /// The box that shows the numbers, in logical pixels; empty: hidden.
    QRectF place;

signals:
    void changed();
    void began();

private:
    const TypesNumbers& numbers() const { return held_.as<TypesNumbers>(); }
    void typeFirstPoint(const QString& text);

    HeldTool& held_;
    std::optional<app::Readout> readout_;
    bool going_ = false;
};

} // namespace ui
