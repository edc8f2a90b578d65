// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// Values from the settings file, treated as untrusted input.

namespace app {

/// A whole number from `least` to `most`; `usual` if the file has no such number.
int rememberedNumber(const QString& key, int least, int most, int usual);

/// A finite number from `least` to `most`; `usual` if the file has no such number.
double rememberedNumber(const QString& key, double least, double most, double usual);

/// The absolute path of a folder that exists; `usual` if the file has no such path.
QString rememberedFolder(const QString& key, const QString& usual);

} // namespace app
