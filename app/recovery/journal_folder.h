// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

// The files of a journal: a folder with a lock, and for each generation a base (`base-3`) and the
// log that continues from it (`log-3`). While the base of the next generation is being written,
// records already go to the next log.
//
// No single damaged file costs the drawing: two ways lead to its present state. The previous
// generation stays, because its base and its log lead up to the newest base. A base without such a
// predecessor has a copy (`copy-1`).

namespace app {

QString newJournalFolder(const QString& above); ///< a name that no other journal uses
bool isJournal(const QString& path);            ///< a folder with such a name, not a link to one
QString baseFile(const QString& folder, int generation);
QString copyFile(const QString& folder, int generation); ///< of the base
QString logFile(const QString& folder, int generation);

/// A file with a base.
struct BaseFile {
    int generation;
    QString path;
};
std::vector<BaseFile> baseFiles(const QString& folder); ///< the newest first; a copy after its base
std::vector<int> logGenerations(const QString& folder); ///< the oldest first

/// Puts the base of a generation on the disk, and removes what is no longer needed. `continues`:
/// the logs of the previous base lead up to this one. Returns nothing, or why it failed; then the
/// older files are still there.
std::optional<QString> putBase(const QString& folder, int generation, std::string_view bytes,
                               bool continues);
/// Writes the copy of a base, if there is room.
bool putCopy(const QString& folder, int generation, std::string_view bytes);

/// Creates a folder that only the user can read; an existing one is closed to all others. A link
/// is left as it is: what it leads to may be meant for others.
void makePrivateFolder(const QString& path);
/// Creates the folder, which only the user can read, and its lock. Null if that fails.
std::shared_ptr<QLockFile> createJournalFolder(const QString& folder);
/// Locks an existing journal; null while the process that writes it is running, and for a folder
/// that has neither a base nor a log, but other contents: it is no journal.
std::shared_ptr<QLockFile> lockJournal(const QString& folder);
/// Removes the files of a journal, and its folder if nothing else is in it. Follows no link.
void removeJournal(const QString& folder);

} // namespace app
