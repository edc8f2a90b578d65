// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of this room, for translators: `Experiments::tr("Text")`.
struct Experiments {
    Q_DECLARE_TR_FUNCTIONS(Experiments)
};

} // namespace app
