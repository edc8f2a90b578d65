// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/shown_steps.h"

#include <deque>
#include <functional>

namespace ui {

class Actor;
class MainWindow;

/// A part of a step, short enough for one event, and the milliseconds that pass before it.
struct Beat {
    int wait;
    std::function<void()> act;
};

/// What an actor does at a step. The actor outlives it.
std::deque<Beat> beatsOf(const app::ShownStep& step, MainWindow& window, Actor& actor);

} // namespace ui
