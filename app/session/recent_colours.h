// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <QSettings>

#include <vector>

namespace app {

constexpr std::size_t mostRecentColours = 12;

/// The colours that were chosen last, the newest first, each once.
std::vector<Colour> recentColours(const QSettings& settings);
void rememberColour(QSettings& settings, const Colour& colour);

} // namespace app
