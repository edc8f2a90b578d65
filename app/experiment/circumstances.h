// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <vector>

namespace app {

/// On what, and with what, something was measured: names and what they stand for, in the order in
/// which they are printed ("processor", "compiler", "flags", "clearcut" ...).
std::vector<std::pair<QString, QString>> circumstances();

} // namespace app
