// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>
#include <QStringList>

namespace app {

/// The page of an algorithm in resources/algorithms/KEY.md.
struct AlgorithmPage {
    QString markdown; ///< all of it; what the row says of itself where there is no page
    QStringList code; ///< its pseudo-code without numbers: line 1 of a trace is code[0]
};
AlgorithmPage pageOf(const clipping::Algorithm& algorithm);

/// The numbered lines of the first block of code that has any.
QStringList pseudoCode(const QString& markdown);

} // namespace app
