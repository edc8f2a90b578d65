// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/replay.h"

// Reads the files of a journal, which may be damaged.

namespace app {

/// The state of a journal, found without reading its drawing.
struct KnownJournal {
    JournalState state{};
    bool damaged = false; ///< some of its last records cannot be read
};
/// Empty if no base of it begins readably.
std::optional<KnownJournal> known(const QString& folder);

/// Replays a journal, by the way that leads farthest. Empty if no base of it is readable.
std::optional<Recovered> replayed(const QString& folder);
/// Replays a journal that has no readable base. It starts from the file that was opened, if that has
/// not changed since, or from an empty drawing. Empty if no step can be replayed.
std::optional<Recovered> salvaged(const QString& folder);

/// Where the drawing came from, according to the oldest log.
JournalOrigin firstOrigin(const QString& folder);
/// Whether there is something in it; otherwise it is only the beginning of a journal.
bool hasContents(const QString& folder);
QDateTime lastWritten(const QString& folder);

} // namespace app
