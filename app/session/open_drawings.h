// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QStringList>

namespace app {

/// The drawings that were open, to be opened again at the next start.
struct OpenDrawings {
    QStringList files; ///< absolute paths, in the order of the tabs, each once
    int shown = -1;    ///< index in files; -1: a drawing without a file
    friend bool operator==(const OpenDrawings&, const OpenDrawings&) = default;
};

/// As they were kept, at most `most`. Empty if they are not reopened, or none were open.
OpenDrawings openDrawings(const QSettings& settings, int most);
void keepOpenDrawings(QSettings& settings, const OpenDrawings& drawings);

/// Whether they are opened again; on at first.
bool reopensDrawings(const QSettings& settings);
void setReopensDrawings(QSettings& settings, bool on);

} // namespace app
