// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace app {

/// Nothing if a file can be named so, else what is wrong and what to do, to stand after "Cannot
/// open NAME: ". File names are UTF-8 here; of others the bytes are lost where Qt made them text,
/// so a file that is written would get another name than was asked for.
std::optional<QString> faultOfName(const QString& path);

} // namespace app
