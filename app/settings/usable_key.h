// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/key_table.h"

namespace app {

/// The characters that begin a number on the canvas, and those that begin a point there.
inline constexpr QStringView beginNumber = u"0123456789.,-+<(", beginPoint = u"@#";

/// Why a key cannot be the shortcut of any command of this scope, in one sentence; empty: it can.
QString whyNoShortcut(const QKeySequence& key, KeyedCommand::Scope scope);

} // namespace app
