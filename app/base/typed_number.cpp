// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/typed_number.h"

namespace app {

QString inCLocale(QString text, const QLocale& locale)
{
    text = text.simplified();
    text.replace(u'\u2212', u'-').replace(u'\u00d7', u'*').replace(u'\u00f7', u'/');
    text.remove(locale.groupSeparator());
    text.replace(locale.decimalPoint(), QStringLiteral("."));
    return text;
}

Result<double> typedLength(const QString& text, const Scale& scale, const QLocale& locale)
{
    return evaluated(inCLocale(text, locale).toStdString(), scale);
}

} // namespace app
