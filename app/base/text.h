// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace app {

/// The program's texts, for translators: `Text::tr("Open")`. All are in this one context, so that a
/// word is translated once; where it has two meanings, the second argument tells them apart.
struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

} // namespace app
