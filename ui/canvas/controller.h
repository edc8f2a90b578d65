// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/digits.h"
#include "ui/canvas/frames.h"
#include "ui/canvas/gesture_steps.h"
#include "ui/canvas/own_keys.h"
#include "ui/canvas/pointing.h"

namespace ui {

/// What all surfaces share: panes side by side have one view, one tool and one gesture. It joins
/// the parts, each with a state of its own, sends them events, and tells what has changed. It does
/// not depend on widgets.
class Controller : public QObject {
    Q_OBJECT

public:
    explicit Controller(app::Session& session, QObject* parent = nullptr);

    app::Session& session() const { return held_.session(); }
    Navigation& navigation() { return navigation_; }
    const app::View& view() const { return navigation_.view(); }
    HeldTool& held() { return held_; }
    const HeldTool& held() const { return held_; }
    const Tool& tool() const { return held_.tool(); }
    const ToolInfo& toolInfo() const { return held_.info(); }
    const Workbench& bench() const { return held_.bench(); }
    const std::optional<Pointer>& pointer() const { return held_.pointer; }
    Typing& typing() { return typing_; }
    const Typing& typing() const { return typing_; }
    Aim& aim() { return aim_; }
    const Aim& aim() const { return aim_; }
    Pointing& pointing() { return pointing_; }
    const Pointing& pointing() const { return pointing_; }
    GestureSteps& steps() { return steps_; }
    Frames& frames() { return frames_; }
    const Frames& frames() const { return frames_; }

    const Look& look() const { return look_; } ///< of the theme
    void setLook(const Look& look);
    const Look& paperLook() const { return bench().look; } ///< of what lies on the drawing
    QColor pageColour() const; ///< of the page's background, unless the paper is dark
    /// The current clip window, also during a gesture.
    std::optional<clipping::Window> clipWindow() const { return session().clipWindow(); }
    /// The controls of what is chosen (capsule.h) that are shown; null: none are.
    const QObject* capsule() const { return capsule_; }
    /// Where they lie on the drawing, in logical pixels; empty: not there.
    const QRectF& capsulePlace() const { return capsulePlace_; }
    void setCapsule(const QObject* capsule, const QRectF& place);
    /// Whether keys and the capsule are for the chosen clip window: with the tool Clip window, or
    /// if it was chosen after the selected objects.
    bool actsOnWindow() const;
    bool gestureGoes() const { return held_.busy() || pointing_.drags(); }
    /// What a digit does now. One that chooses the algorithm is a shortcut of the menu Clip, which
    /// digitsChoose() allows: the canvas takes the digits of a gesture before.
    app::DigitUse digitUse() const { return app::digitUse(digitPlace()); }
    bool digitsChoose() const; ///< outside gestures
    /// Tools and views have keys by commands, which the person may change; `own` are those of
    /// commands that the canvas itself understands.
    void leaveKeysToCommands(const OwnKeys::Keys& own)
    {
        leavesKeys_ = true;
        keys_.tell(own);
    }
    bool leavesKeys() const { return leavesKeys_; }
    const OwnKeys& keys() const { return keys_; }

    /// Handles an event of a widget that shows the drawing; true if the event was consumed.
    bool handle(QEvent& event);
    /// Ends the gesture and keeps what is complete. To be called before the document is read or the
    /// view changes under the pointer.
    void endGesture();
    std::optional<app::ObjectInHand> unfinished() const; ///< what endGesture() would keep now
    /// Moves, rotates, scales or skews the selection with the Select tool, from the keyboard.
    void transform(const app::Transformation& kind);

signals:
    void changed(); ///< repaint
    void pointerMoved(std::optional<app::Point> position);
    void capsuleWanted(); ///< the keyboard should go to it
    void hintChanged();

private:
    void connectSession();
    void inspectOnly();
    void outdate();
    void renew();
    void followDisplay();
    void followScale(const app::DocumentChange& change);
    void tellHint();
    app::DigitPlace digitPlace() const;

    Navigation navigation_;
    HeldTool held_;
    Typing typing_;
    Aim aim_;
    Pointing pointing_;
    GestureSteps steps_;
    Frames frames_;
    Look look_;
    app::Display shown_; ///< except the algorithm, which each pane has of its own
    const QObject* capsule_ = nullptr;
    QRectF capsulePlace_;
    bool leavesKeys_ = false;
    OwnKeys keys_;
    double paperUnit_ = 0;                     ///< millimetres of a user unit on the last page
    std::pair<QString, app::DigitUse> told_{}; ///< the hint and what a digit does
    app::ObjectRanges inspectedSelection_;     ///< the last one that inspectOnly() has seen
};

} // namespace ui
