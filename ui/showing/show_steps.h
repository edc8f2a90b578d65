// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/teaching/manual.h"
#include "app/teaching/shown_steps.h"

namespace ui {

class MainWindow;

/// Shows the steps of a page in a drawing of its own, in a further tab of the program that `from`
/// belongs to. Returns why that cannot be, in one sentence; empty: they are being shown, or the
/// window has said why not.
QString showSteps(MainWindow& from, const app::ManualPage& page);

/// What is wrong with steps that name commands or numbers which this program does not have, or
/// commands that a page must not run; empty: nothing.
QString faultOf(MainWindow& window, const app::ShownSteps& steps);

/// The drawing in which the steps are shown: a copy, a sample, or an empty one.
app::Document drawingFor(const app::Document& own, const app::ShownSteps& steps);

} // namespace ui
