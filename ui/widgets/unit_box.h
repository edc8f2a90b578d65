// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QToolButton>

namespace ui {

/// The selectable units, in menu order.
std::vector<app::Unit> shownUnits();

/// The unit of the lengths beside it; a click opens the list of units.
class UnitButton : public QToolButton {
    Q_OBJECT

public:
    explicit UnitButton(app::Session& session, QWidget* parent = nullptr);
};

/// Opens the list of units at a place of the screen.
void openUnits(app::Session& session, QWidget& parent, const QPoint& place);

} // namespace ui
