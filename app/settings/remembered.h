// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// What the settings file says, read as if a stranger had written it.

namespace app {

/// A whole number from `least` to `most`; `usual` if there is none.
int rememberedNumber(const QString& key, int least, int most, int usual);

/// A finite number from `least` to `most`; `usual` if there is none.
double rememberedNumber(const QString& key, double least, double most, double usual);

/// A folder that exists, by its absolute path; `usual` if there is none.
QString rememberedFolder(const QString& key, const QString& usual);

} // namespace app
