// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The texts of these files, for translators: `Sentences::tr("Text")`.
struct Sentences {
    Q_DECLARE_TR_FUNCTIONS(sentences)
};

} // namespace app
