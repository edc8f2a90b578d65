// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <QStringList>

#include <optional>

namespace app {

/// The papers that are offered for sheets, from small to large.
QStringList papers();
/// The size of a paper ("A4", "Letter", in any case) in millimetres, portrait; empty: unknown.
/// Other papers than those offered are known, too.
std::optional<Point> paperSize(const QString& name);

} // namespace app
