// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of this room, for translators: `Reports::tr("Text")`.
struct Reports {
    Q_DECLARE_TR_FUNCTIONS(Reports)
};

} // namespace app
