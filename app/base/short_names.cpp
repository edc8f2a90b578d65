// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/short_names.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <algorithm>

namespace app {
namespace {

QString abbreviation(const Variant& variant)
{
    const auto text = variant.algorithm->abbreviation;
    return latin(text);
}

} // namespace

QString shortNameOf(const Variant& variant)
{
    return variant.form == clipping::Form::Published
               ? Text::tr("%1 as published").arg(abbreviation(variant))
               : abbreviation(variant);
}

QString nameAmong(std::span<const Variant> all, std::size_t i)
{
    const bool mixed =
        std::ranges::any_of(all, [&](const Variant& other) { return other.form != all[i].form; });
    return mixed ? shortNameOf(all[i]) : abbreviation(all[i]);
}

QString introducedName(const clipping::Algorithm& algorithm)
{
    const auto name = latin(algorithm.name);
    return algorithm.name == algorithm.abbreviation
               ? name
               : Text::tr("%1 (%2)").arg(name,
                                         abbreviation({&algorithm, clipping::Form::Corrected}));
}

QString listText(const QStringList& names)
{
    if (names.size() < 2)
        return names.join(QString());
    return Text::tr("%1 and %2")
        .arg(names.sliced(0, names.size() - 1).join(QStringLiteral(", ")), names.back());
}

QString briefListText(const QStringList& names)
{
    constexpr qsizetype mostNamed = 7, named = 3;
    if (names.size() <= mostNamed)
        return listText(names);
    return listText(names.first(named) << Text::tr("%1 others").arg(names.size() - named));
}

QString timeText(double nanoseconds)
{
    return Text::tr("%1 ns per line").arg(numberText(nanoseconds, nanoseconds < 100 ? 2 : 0));
}

} // namespace app
