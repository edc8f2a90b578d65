// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <vector>

namespace app {

/// The machine and the software of a measurement: names and values, in the order in which they are
/// printed ("processor", "compiler", "flags", "clearcut" ...).
std::vector<std::pair<QString, QString>> circumstances();

} // namespace app
