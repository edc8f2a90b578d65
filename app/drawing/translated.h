// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of these files, for translators: `GestureMeasures::tr("Text")`.
struct GestureMeasures {
    Q_DECLARE_TR_FUNCTIONS(GestureMeasure)
};

} // namespace app
