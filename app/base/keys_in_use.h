// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QString>

namespace app {

/// The first keys of commands, as a person reads them: "tool-window" has "W".
using KeysInUse = QHash<QString, QString>;

/// The standard keys of the commands that sentences name.
const KeysInUse& standardKeysInSentences();

/// Tells the keys that the commands have from now on; before, they have the standard ones.
void tellKeysInUse(const KeysInUse& keys);

/// The first key of a command as a person reads it; empty: it has none.
QString keyInUse(const QString& command);

/// A sentence with the keys of the commands that it names: "Draw one first ({tool-window})." A
/// command without a key leaves nothing in brackets, and a dash elsewhere. Names that a person gave
/// are put in afterwards, or they would be read as those of commands: withKeys(text).arg(name).
/// Only on the interface's thread.
QString withKeys(QString sentence);

} // namespace app
