// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/record.h"

#include "app/comparison/variants.h"

#include <QSettings>

#include <algorithm>

namespace app {

namespace {

QString bestKey(const Variant& variant)
{
    return QStringLiteral("practice/best/") + keyOf(variant);
}
QString passedKey(const Variant& variant)
{
    return QStringLiteral("practice/passed/") + keyOf(variant);
}

} // namespace

std::optional<PracticeRecord> recordOf(const QSettings& settings, const Variant& variant)
{
    bool isNumber = false;
    const int best = settings.value(bestKey(variant)).toInt(&isNumber);
    if (!isNumber)
        return std::nullopt;
    return PracticeRecord{std::clamp(best, 0, 100), settings.value(passedKey(variant)).toBool()};
}

void keepRecord(QSettings& settings, const Variant& variant, PracticeRecord attempt)
{
    if (const auto record = recordOf(settings, variant))
        attempt = {std::max(record->best, attempt.best), record->passed || attempt.passed};
    settings.setValue(bestKey(variant), std::clamp(attempt.best, 0, 100));
    settings.setValue(passedKey(variant), attempt.passed);
}

} // namespace app
