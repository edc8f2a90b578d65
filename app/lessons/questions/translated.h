// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of these files, for translators: `Questions::tr("Text")`.
struct Questions {
    Q_DECLARE_TR_FUNCTIONS(questions)
};

} // namespace app
