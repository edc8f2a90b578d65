// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of these files, for translators: `Overlays::tr("Text")`.
struct Overlays {
    Q_DECLARE_TR_FUNCTIONS(Overlay)
};

} // namespace app
