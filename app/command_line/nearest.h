// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace app {

/// The most similar of `words` (at least one): with the fewest letters inserted, deleted or
/// exchanged.
QString nearestTo(const QString& word, const QStringList& words);

} // namespace app
