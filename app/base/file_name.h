// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace app {

/// Checks that a file can have this name. Empty if so; otherwise a text that says what is wrong and
/// what to do, to follow "Cannot open NAME: ". File names must be UTF-8: Qt has lost the bytes of
/// any other name, so a file written under it would get a different name.
std::optional<QString> faultOfName(const QString& path);

} // namespace app
