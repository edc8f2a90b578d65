// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/case_filter.h"

#include "app/base/text.h"
#include "app/comparison/variants.h"

#include <QLocale>

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr std::array kinds{
    std::pair{Ruling::DidNotEnd, QT_TRANSLATE_NOOP("Text", "An algorithm never ends")},
    std::pair{Ruling::Lost, QT_TRANSLATE_NOOP("Text", "Something visible is lost")},
    std::pair{Ruling::Shown, QT_TRANSLATE_NOOP("Text", "Something is shown that is not visible")},
    std::pair{Ruling::Outside, QT_TRANSLATE_NOOP("Text", "An end is outside the window")},
    std::pair{Ruling::Moved, QT_TRANSLATE_NOOP("Text", "An end is at the wrong place")},
    std::pair{Ruling::NotANumber, QT_TRANSLATE_NOOP("Text", "An end is not a number")}};

CaseChoice choice(const QString& name, const CaseFilter& filter)
{
    const auto count = QLocale().toString(int(casesFor(filter).size()));
    return {QStringLiteral("%1 (%2)").arg(name, count), filter};
}

} // namespace

bool CaseFilter::lets(const HardCase& hard) const
{
    const QString text = hard.title + u'\n' + hard.origin + u'\n' + hard.why + u'\n' + hard.key;
    for (const QString& word : words.split(u' ', Qt::SkipEmptyParts))
        if (!text.contains(word, Qt::CaseInsensitive))
            return false;
    if (variant.isEmpty() && !fault)
        return true;
    return std::ranges::any_of(hard.faults, [this](const auto& one) {
        return (variant.isEmpty() || one.first == variant) && (!fault || one.second == *fault);
    });
}

std::vector<const HardCase*> casesFor(const CaseFilter& filter)
{
    std::vector<const HardCase*> cases;
    for (const HardCase& hard : hardCases())
        if (filter.lets(hard))
            cases.push_back(&hard);
    return cases;
}

std::vector<CaseChoice> caseChoices()
{
    std::vector<CaseChoice> choices{choice(Text::tr("All cases"), {})};
    for (const Variant& variant : variants())
        if (variant.form == clipping::Form::Published)
            choices.push_back(
                choice(Text::tr("%1 fails").arg(nameOf(variant)), {.variant = keyOf(variant)}));
    for (const auto& [fault, name] : kinds)
        choices.push_back(choice(Text::tr(name), {.fault = fault}));
    return choices;
}

} // namespace app
