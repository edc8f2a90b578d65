// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/last_step.h"
#include "ui/tools/shape_drawing.h"

namespace ui {

/// Makes something from one point to another, by a drag or by two clicks. Numbers typed afterwards
/// change it, until something else happens.
class TwoPointGesture : public Tool, public TypesNumbers {
public:
    void press(const Pointer& pointer, Workbench& bench) override;
    void move(const Pointer& pointer, Workbench& bench) override;
    void release(const Pointer& pointer, Workbench& bench) override;
    void cancel(Workbench& bench) override;
    bool busy() const override { return gesture_.has_value(); }
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void reopen(Workbench& bench) override;
    bool corrects() const override { return last_.isOpen(); }
    QString hint(const Workbench& bench) const override;
    /// Whether numbers typed now would change what was made last.
    bool canCorrect(const Workbench& bench) const { return last_.canReopen(bench); }

protected:
    struct Gesture {
        app::Point from, to;
        Qt::KeyboardModifiers modifiers;
        app::Numbers numbers{}; ///< as the readout shows them
    };

    virtual const app::GestureMeasure& measure(Qt::KeyboardModifiers modifiers) const = 0;
    /// Of the measure's kept numbers, those of the first gesture, and the key under which they are
    /// kept; empty: there are none.
    virtual app::Numbers usual() const { return {}; }
    virtual std::string_view keeps() const { return {}; }
    /// Pushes the step that the gesture makes.
    virtual void make(Workbench& bench) = 0;
    /// The gesture has begun or its end has moved.
    virtual void follow(const Gesture&, Workbench&) {}
    /// Ends the gesture at the second click.
    virtual void finishByClick(Workbench& bench) { finish(bench); }

    void begin(const app::Point& from, Workbench& bench);
    bool isEmpty() const { return firstZero().has_value(); } ///< one of the lengths is 0
    /// Whether one of the lengths is 0; says so, and the gesture goes on.
    bool refusesEmpty(Workbench& bench) const;
    /// Makes the step, which numbers can change until something else happens.
    void add(Workbench& bench);
    std::optional<Gesture> gesture_;

private:
    std::optional<std::size_t> firstZero() const;
    std::optional<app::GestureEnd> sameAgain(const Workbench& bench) const;
    void moveEnd(const app::Point& to, Workbench& bench);
    void finish(Workbench& bench);

    std::optional<app::Point> pressed_; ///< on the screen; empty: the button is up
    std::optional<app::Point> screen_;  ///< where the pointer was last
    /// Where it was when the gesture began. While it waits there, a box is as large as the last
    /// one, and typed sides go right and down.
    std::optional<app::Point> waitsAt_;
    bool waits_ = false;
    LastStep last_;
    Gesture done_{}; ///< the gesture of that step
};

} // namespace ui
