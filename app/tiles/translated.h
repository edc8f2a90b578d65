// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of these files, for translators: `Tiles::tr("Text")`.
struct Tiles {
    Q_DECLARE_TR_FUNCTIONS(Tiles)
};

} // namespace app
