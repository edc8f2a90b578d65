// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>
#include <QStringList>

namespace app {

/// The page of an algorithm in resources/algorithms/KEY.md.
struct AlgorithmPage {
    QString markdown; ///< the whole page; without a page, the description in the algorithm's row
    QStringList code; ///< its first pseudo-code, without line numbers
};
/// Reads a page, in which a line {published code} or {corrected code} is replaced by the library's
/// pseudo-code of that form.
AlgorithmPage pageOf(const clipping::Algorithm& algorithm);

/// The pseudo-code of a form without line numbers: line 1 of a trace is the first.
QStringList codeOf(const Variant& variant);

/// The numbered lines of the first code block that has any.
QStringList pseudoCode(const QString& markdown);

} // namespace app
