// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of these files, for translators: `HardCases::tr("Text")`.
struct HardCases {
    Q_DECLARE_TR_FUNCTIONS(hard_cases)
};

} // namespace app
