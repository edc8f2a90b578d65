// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <span>
#include <string_view>

namespace app {

/// What objects may have in common with the selection: a row of a catalogue.
struct Likeness {
    std::string_view key;
    QString name; ///< "Same &colour"
    /// Those objects that are like a selected one, also locked and hidden ones.
    ObjectRanges (*like)(const Session& session);
};
// THE CATALOGUE. To add a likeness: add its row.
std::span<const Likeness> likenesses();

// Each changes the selection only. Objects in groups are selected one by one.
void selectAlike(Session& session, const Likeness& likeness);
void invertSelection(Session& session);
void selectLayer(Session& session, ContainerId layer); ///< everything in it

/// Selects the objects that have this id or title, and those of groups and layers with this id or
/// name. An exact id wins; otherwise the text may be a part, in upper or lower case. Returns what
/// was found, in one sentence.
QString find(Session& session, const QString& text);

} // namespace app
