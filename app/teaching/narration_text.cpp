// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/teaching/narration.h"

#include <QLocale>

#include <array>

// The words and numbers of a trace.

namespace app {

namespace {

QString withMinus(QString text) { return text.replace(u'-', u'\u2212'); }

} // namespace

QString exactText(double value)
{
    return withMinus(QLocale().toString(value, 'g', QLocale::FloatingPointShortest));
}

QString shortText(double value) { return withMinus(QLocale().toString(value, 'g', 6)); }

QString valueText(const Variable& variable)
{
    switch (variable.kind) {
    case clipping::ValueKind::Bits:
        return outcodeText(unsigned(variable.value));
    case clipping::ValueKind::Truth:
        return variable.value != 0 ? Text::tr("yes") : Text::tr("no");
    default:
        return exactText(variable.value);
    }
}

} // namespace app
