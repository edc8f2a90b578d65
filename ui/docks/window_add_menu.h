// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

class QMenu;
class QWidget;

namespace ui {

/// What the button + of the clip windows offers: every shape, every place, the selected objects.
QMenu* makeWindowAddMenu(app::Session& session, QWidget& parent);

} // namespace ui
