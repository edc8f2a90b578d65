// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QDateTime>
#include <QLockFile>

#include <memory>
#include <optional>
#include <vector>

// Drawings that were not saved when the program was ended: one SVG file each, which any program
// opens, with a processing instruction after the drawing that says what it was.

namespace app {

/// What has to be known of a drawing to go on with it.
struct Origin {
    QString name;       ///< as the title called it
    QString path;       ///< where Save goes; empty: it asks
    QDateTime fileTime; ///< when the file there was last changed, as far as the program knew
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// A drawing that was left, claimed by this process while it lives: no other offers it.
struct Leftover {
    QString file;
    Origin origin;
    QDateTime ended; ///< when the program was ended
    std::shared_ptr<QLockFile> claim;
};

/// In the user's state folder ($XDG_STATE_HOME, else ~/.local/state).
QString leftoverFolder();

/// Writes a file for a drawing, whole or not at all, and makes the folder; only the user can read
/// either of them. Nothing, or the error.
std::optional<QString> writeLeftover(const Document& document, const Origin& origin,
                                     const QString& file);

/// A name in `folder` that no other process uses.
QString newLeftoverFile(const QString& folder);

/// Those in `folder` that no other process has claimed, the newest first. Any other file there is
/// left alone.
std::vector<Leftover> claimLeftovers(const QString& folder);

/// Deletes it: it was saved, or given up.
void discard(Leftover& leftover);

/// One whose drawing cannot be read: renamed, so that it is never offered again, but not lost. The
/// new name.
QString setAside(Leftover& leftover);

} // namespace app
