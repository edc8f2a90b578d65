// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace app {

/// What a file is by its first bytes, whatever its name says.
struct ContentKind {
    QString name;   ///< "a PDF document"
    QString ending; ///< with which more is said of it, such as "dxf"; empty: it is not read
};

constexpr qsizetype contentHead = 512; ///< so many bytes are enough

/// Empty names: it is of no kind that is known.
ContentKind contentKind(const QByteArray& head);

} // namespace app
