// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>
#include <QStringList>

namespace app {

/// The page of an algorithm in resources/algorithms/KEY.md.
struct AlgorithmPage {
    QString markdown; ///< all of it; what the row says of itself where there is no page
    QStringList code; ///< its first pseudo-code, without numbers
};
/// A page takes the pseudo-code of a form from the library: where it says {published code} or
/// {corrected code} on a line of its own.
AlgorithmPage pageOf(const clipping::Algorithm& algorithm);

/// The pseudo-code of a form without numbers: line 1 of a trace is the first.
QStringList codeOf(const Variant& variant);

/// The numbered lines of the first block of code that has any.
QStringList pseudoCode(const QString& markdown);

} // namespace app
