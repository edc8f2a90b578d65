// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"

#include <QTimer>

namespace ui {

/// Plays the steps of the microscope one after the other. It stops at the last one, and when the
/// microscope is closed; at the end it begins again from the first.
class Playback : public QObject {
    Q_OBJECT

public:
    explicit Playback(app::Microscope& microscope, QObject* parent = nullptr);

    bool playing() const { return tick_.isActive(); }
    void play();
    void stop();
    void toggle() { playing() ? stop() : play(); }
    /// 1: a step a second and a half.
    void setSpeed(double speed);

signals:
    void playingChanged();

private:
    void step();

    app::Microscope& microscope_;
    QTimer tick_;
};

} // namespace ui
