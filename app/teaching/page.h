// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>
#include <QStringList>

namespace app {

/// The page of an algorithm in resources/algorithms/KEY.md, in Markdown; without a page, the
/// description in the algorithm's row. A line {published code} or {corrected code} of the file is
/// replaced by the library's pseudo-code of that form.
QString pageOf(const clipping::Algorithm& algorithm);

/// The lines of a labelled pseudo-code (clipping/pseudo_code.h) as they are shown.
QStringList shownCode(std::string_view code);
/// The same of a form.
QStringList codeOf(const Variant& variant);

} // namespace app
