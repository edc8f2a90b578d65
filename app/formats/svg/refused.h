// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app::svg {

/// Thrown inside the reader if a file cannot be read, and caught at the reader's border. `why` ends
/// with a full stop. It continues "line 12 " ("is not complete."), or the file's name if it
/// concerns the whole file ("it is empty.").
struct Refused {
    static constexpr qint64 here = 0, wholeFile = -1;
    QString why;
    qint64 line = here; ///< `here`: the reader inserts its current line
};

} // namespace app::svg
