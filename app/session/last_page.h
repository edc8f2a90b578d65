// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

#include <QString>

namespace app {

/// The page of a new drawing as a text for the settings, such as
/// "420 297 scale=50 unit=m margins=20,10,10,10 shown": paper and margins in millimetres.
QString pageText(const Page& page);

/// The page of such a text, with a user unit of one real millimetre. An A3 sheet, landscape, if the
/// text is damaged: settings are written by anyone.
Page pageFromText(const QString& text);

} // namespace app
