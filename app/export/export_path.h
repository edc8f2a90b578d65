// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <QString>

namespace app {

/// A path as people read it: "~/Drawings/map.png" in the home folder.
QString shownPath(const QString& path);
/// The path that a typed one means: absolute, with the ending of the format unless it has it. A
/// name without a folder is in the home folder.
QString writtenPath(const QString& typed, const Format& format);
/// The path with the ending of this format in place of that of another one.
QString withEnding(const QString& path, const Format& format);

/// What is worth knowing before a file is written there; may be empty.
struct PathRemark {
    QString text;
    bool isFault = false; ///< it cannot be written
};
PathRemark remarkOn(const QString& path);

} // namespace app
