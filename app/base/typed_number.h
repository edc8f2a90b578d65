// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/expression.h"

#include <QLocale>

namespace app {

/// Numbers as people type them, in the C locale: minus and multiplication signs are ASCII, the
/// locale's decimal point is ".", its group separators are gone.
QString inCLocale(QString text, const QLocale& locale);

/// evaluated() for text as people type it.
Result<double> typedLength(const QString& text, const Scale& scale, const QLocale& locale = {});

} // namespace app
