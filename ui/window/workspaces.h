// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <string_view>

namespace ui {

/// Which panels the column at the right shows for one kind of work. A workspace has panes of its
/// own (workspace_panes.h), and changes nothing else: neither the document nor the view. One row of
/// a catalogue.
struct Workspace {
    std::string_view key; ///< in the settings, and of its command
    QString name;
    QString tip;            ///< what it is for
    QStringList column;     ///< keys of its panels, from top to bottom
    QStringList folds = {}; ///< those of them that fold, and are folded at first
    bool draws = false;     ///< for drawing rather than for cutting
    bool compares = false;  ///< what it shows does not cut; the bar offers how many panes there are
};

/// In the order of the tabs.
std::span<const Workspace> workspaces();
const Workspace&
findWorkspace(std::string_view key); ///< the usual one if there is none of this key

} // namespace ui
