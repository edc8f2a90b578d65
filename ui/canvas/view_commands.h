// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/canvas/navigation.h"

#include <QKeyEvent>

// What a person asks of the view: to fit a part of the drawing, or to zoom.

namespace ui {

void fitDrawing(const app::Session& session, Navigation& view);   ///< nothing is drawn: the page
void fitPage(const app::Session& session, Navigation& view);      ///< and everything that is drawn
void fitSelection(const app::Session& session, Navigation& view); ///< empty: the drawing
void fitWindow(const app::Session& session, Navigation& view);    ///< the clip window

/// 1 = 100 %: 1 mm on paper is 96 / 25.4 logical pixels.
double zoomOf(const app::Session& session, const Navigation& view);
void setZoom(double zoom, const app::Session& session, Navigation& view);
void zoomBy(double factor, Navigation& view);

/// The keys for it; true: consumed.
bool keyOfView(const QKeyEvent& event, const app::Session& session, Navigation& view);

} // namespace ui
