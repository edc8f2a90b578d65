// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"

#include <QTimer>

namespace ui {

/// Plays the microscope's steps one after the other. It stops at the last step and when the
/// microscope is closed; play() at the last step begins again from the first.
class Playback : public QObject {
    Q_OBJECT

public:
    explicit Playback(app::Microscope& microscope, QObject* parent = nullptr);

    bool playing() const { return tick_.isActive(); }
    void play();
    void stop();
    void toggle() { playing() ? stop() : play(); }
    /// 1 is one step every 1.5 s.
    void setSpeed(double speed);

signals:
    void playingChanged();

private:
    void step();

    app::Microscope& microscope_;
    QTimer tick_;
};

} // namespace ui
