// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/playback.h"

namespace ui {

namespace {

constexpr double usualMilliseconds = 1500; // long enough to read a sentence

} // namespace

Playback::Playback(app::Microscope& microscope, QObject* parent)
    : QObject(parent), microscope_(microscope)
{
    setSpeed(1);
    connect(&tick_, &QTimer::timeout, this, &Playback::step);
    connect(&microscope, &app::Microscope::openChanged, this, &Playback::stop);
}

void Playback::play()
{
    if (microscope_.narration().steps.empty())
        return;
    if (microscope_.atEnd())
        microscope_.goTo(0);
    tick_.start();
    emit playingChanged();
}

void Playback::stop()
{
    if (!playing())
        return;
    tick_.stop();
    emit playingChanged();
}

void Playback::setSpeed(double speed) { tick_.setInterval(int(usualMilliseconds / speed)); }

void Playback::step()
{
    microscope_.next();
    if (microscope_.atEnd())
        stop();
}

} // namespace ui

#include "moc_playback.cpp"
