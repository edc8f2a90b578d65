// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/style_table.h"

#include <QSettings>

#include <vector>

namespace app {

constexpr std::size_t mostRecentColours = 12;

/// The colours that were chosen last, the newest first, each once.
std::vector<Colour> recentColours(const QSettings& settings);
void rememberColour(QSettings& settings, const Colour& colour);

/// "#8A5A2B"; with a fourth pair of digits if the colour is not opaque.
QString hexText(const Colour& colour);

/// A colour as people type it: 3, 4, 6 or 8 hexadecimal digits with or without "#", or a notation
/// of CSS ("tomato", "rgb(1 2 3)"). The error is a whole sentence.
Result<Colour> typedColour(const QString& text);

} // namespace app
