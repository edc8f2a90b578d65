// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/walk.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>

// The words and numbers of a trace.

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("walk", text); }

QString withMinus(QString text) { return text.replace(u'-', u'\u2212'); }

} // namespace

QString edgeWords(clipping::Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> up{"", "the left edge", "the right edge",
                                                   "the bottom edge", "the top edge"};
    auto at = std::size_t(edge);
    if (at >= up.size())
        return {};
    if (y == YAxis::Down && at >= 3)
        at = 7 - at;
    return at == 0 ? QString() : tr(up[at]);
}

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
        return variable.value != 0 ? tr("yes") : tr("no");
    default:
        return exactText(variable.value);
    }
}

} // namespace app
