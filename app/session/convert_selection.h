// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

class Session;

/// Why the selection cannot be converted to paths; empty: it can.
QString convertRefusal(const Session& session);

/// Why no selected stroke can become an area; empty: one can.
QString outlineRefusal(const Session& session);

/// Makes plain paths of the selected texts, rectangles, ellipses and stars, as one step.
void convertToPaths(Session& session);

} // namespace app
