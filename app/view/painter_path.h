// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "app/document/style.h"

#include <QPainterPath>

namespace app {

/// An object's outline in user units, with curves kept as curves, and its fill rule.
QPainterPath painterPath(const Path& path, FillRule rule);
QPainterPath painterPath(std::span<const Subpath> subpaths, FillRule rule);

} // namespace app
