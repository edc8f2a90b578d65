// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace app::svg {

/// Thrown inside the reader where a file cannot be read, and caught at its border. `why` ends with
/// a full stop and goes on from "line 12 " ("is not complete."), or from the file's name where it
/// is about the whole file ("it is empty.").
struct Refused {
    static constexpr qint64 here = 0, wholeFile = -1;
    QString why;
    qint64 line = here; ///< `here`: the reader puts in the line that it has come to
};

/// The sentences' translations.
struct Text {
    Q_DECLARE_TR_FUNCTIONS(svg)
};

} // namespace app::svg
