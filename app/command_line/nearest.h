// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace app {

/// Which of `words` (at least one) may have been meant: the one that takes the fewest letters
/// typed, left out or exchanged.
QString nearestTo(const QString& word, const QStringList& words);

} // namespace app
