// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/replay.h"

#include <QLockFile>

#include <memory>

// The files of a journal: a folder with a lock, and for each generation a base (`base-3`) and the
// log that continues from it (`log-3`). While the base of the next generation is being written,
// records already go to the next log; the older files are removed only after it is on the disk.

namespace app {

QString newJournalFolder(const QString& above); ///< a name that no other journal uses
bool isJournal(const QString& path);
QString baseFile(const QString& folder, int generation);
QString logFile(const QString& folder, int generation);
void removeOlder(const QString& folder, int generation); ///< all generations before that one

/// Creates the folder, which only the user can read, and its lock. Null if that fails.
std::shared_ptr<QLockFile> createJournalFolder(const QString& folder);
/// Locks an existing journal; null while the process that writes it is running.
std::shared_ptr<QLockFile> lockJournal(const QString& folder);

bool hasBase(const QString& folder); ///< whether it is more than the beginning of a journal
/// What is known of a journal without reading its drawing; empty if no base of it is readable.
std::optional<JournalState> journalState(const QString& folder);
/// Replays a journal: as many records as are valid. Empty if no base of it is readable.
std::optional<Recovered> replayed(const QString& folder);
/// When its last record was written.
QDateTime lastWritten(const QString& folder);

} // namespace app
