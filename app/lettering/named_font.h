// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// The font for a list of families as style sheets write it: "Arial, 'DejaVu Sans', serif".
struct NamedFont {
    QString family{};  ///< the first that is installed, or else what the system takes for it
    QString missing{}; ///< the first of the list, if it is not installed
};
/// No family in a program without fonts. An empty list and names such as `sans-serif` mean what the
/// system takes for them.
NamedFont namedFont(const QString& families);

} // namespace app
