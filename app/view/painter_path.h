// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"

#include <QPainterPath>

namespace app {

/// The shape's outline in user units, curves as curves, with its fill rule.
QPainterPath painterPath(const Shape& shape);
QPainterPath painterPath(const ObjectView& object);

} // namespace app
