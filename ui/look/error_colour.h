// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

namespace ui {

/// The border and the sentence of a field whose value was refused.
QColor errorColour(const Look& look);

} // namespace ui
