// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <optional>

namespace app {

/// The most similar of `words`: with the fewest letters inserted, deleted or exchanged. Empty if
/// even that is so different that another word was not meant.
std::optional<QString> nearestTo(const QString& word, const QStringList& words);

} // namespace app
