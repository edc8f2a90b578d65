// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The translation context of cost maps.
struct CostMaps {
    Q_DECLARE_TR_FUNCTIONS(CostMaps)
};

} // namespace app
