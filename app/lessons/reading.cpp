// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/reading.h"

#include "app/base/text.h"
#include "app/hard_cases/case_answer.h"
#include "app/hard_cases/case_filter.h"
#include "app/hard_cases/case_use.h"
#include "app/teaching/line_text.h"
#include "app/teaching/manual.h"

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t mostCases = 6; // on a page; the gallery has all of them
const QString ending = QStringLiteral(".md");

/// What fails, and a link that shows it.
QString itemOf(const HardCase& hard, const Variant& variant)
{
    QString text = QStringLiteral("- [%1](clearcut:case/%2): %3")
                       .arg(hard.title, hard.key, answerText(answerOf(hard, variant)));
    if (const auto watch = traceLink(tracedLineOf(hard, variant)))
        text += QStringLiteral(" ([%1](%2))").arg(Text::tr("watch it in the microscope"), *watch);
    return text + u'\n';
}

/// The cases at which the published form fails, a line each.
QString hardCasesOf(const clipping::Algorithm& algorithm)
{
    if (!algorithm.published)
        return {};
    const Variant published{&algorithm, clipping::Form::Published};
    const auto cases = casesFor({.variant = keyOf(published)});
    if (cases.empty())
        return {};
    const bool all = cases.size() <= mostCases;
    QString text =
        QStringLiteral("\n\n## %1\n%2\n")
            .arg(Text::tr("Hard cases"),
                 all ? Text::tr("The published form fails on these lines.")
                     : Text::tr("The published form fails on these lines, among others."));
    for (std::size_t i = 0; i < std::min(cases.size(), mostCases); ++i)
        text += itemOf(*cases[i], published);
    if (!all)
        text +=
            QStringLiteral("\n[%1](clearcut:fails/%2)\n")
                .arg(Text::tr("All %1 cases where it fails").arg(cases.size()), keyOf(published));
    return text;
}

} // namespace

QString readingOf(const clipping::Algorithm& algorithm)
{
    return withoutComments(pageOf(algorithm)) + hardCasesOf(algorithm);
}

const clipping::Algorithm* algorithmOfPage(const QString& link)
{
    const QString name = link.section(u'/', -1);
    return name.endsWith(ending)
               ? clipping::findAlgorithm(name.chopped(ending.size()).toStdString())
               : nullptr;
}

} // namespace app
