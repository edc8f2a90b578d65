// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QDateTime>
#include <QLockFile>

#include <memory>
#include <optional>
#include <vector>

// Drawings that were unsaved when the program ended. Each is a journal (journal.h) or, if its
// journal could not be written, one SVG file, which any program opens, with a processing
// instruction after the drawing that holds its origin.

namespace app {

/// The data needed to continue with a drawing.
struct Origin {
    QString name;       ///< the name in the title
    QString path;       ///< where Save writes; empty: Save asks
    QDateTime fileTime; ///< last change of that file, as far as the program knew
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// A leftover drawing, claimed by this process while it runs: no other process offers it.
struct Leftover {
    QString file; ///< or the folder of a journal
    Origin origin;
    QDateTime ended; ///< when the program was ended; of a journal, when its last step was done
    std::shared_ptr<QLockFile> claim;
};

/// In the user's state folder ($XDG_STATE_HOME, otherwise ~/.local/state).
QString leftoverFolder();

/// Writes the file of a drawing, completely or not at all, and creates the folder; only the user
/// can read them. Empty, or the error.
std::optional<QString> writeLeftover(const Document& document, const Origin& origin,
                                     const QString& file);

/// A file name in `folder` that no other process uses.
QString newLeftoverFile(const QString& folder);

/// The leftovers in `folder` that no other process has claimed, the newest first. Other files in
/// the folder are not touched.
std::vector<Leftover> claimLeftovers(const QString& folder);

/// Deletes a leftover that was saved or abandoned.
void discard(Leftover& leftover);

/// Renames a damaged leftover, so that it is never offered again, but not lost. Returns the new
/// name.
QString setAside(Leftover& leftover);

} // namespace app
