// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/loss_text.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <algorithm>

namespace app {

namespace {

QString counted(const Loss& loss)
{
    return Text::tr("%1 %2").arg(countText(std::size_t(loss.count)), loss.what);
}

QString withPlace(const Loss& loss)
{
    const QString place = whereText(loss);
    return place.isEmpty() ? counted(loss) : Text::tr("%1 (%2)").arg(counted(loss), place);
}

} // namespace

QString lossSentence(const std::vector<Loss>& report)
{
    QStringList lost;
    for (const Loss& loss : report)
        if (!loss.remark)
            lost << counted(loss);
    if (lost.isEmpty())
        return {};
    const QString last = lost.takeLast();
    const QString list =
        lost.isEmpty() ? last : Text::tr("%1 and %2").arg(lost.join(Text::tr(", ")), last);
    return Text::tr("%1 cannot be kept.").arg(list);
}

QString saveAsReason(const std::vector<Loss>& report)
{
    QStringList sentences;
    if (const QString lost = lossSentence(report); !lost.isEmpty())
        sentences << lost;
    if (std::ranges::any_of(report, &Loss::cut))
        sentences << Text::tr("What clip paths hide was cut off; only the file still has it.");
    if (std::ranges::any_of(report, &Loss::outlined))
        sentences << Text::tr(
            "Texts became outlines; only the file still has the texts themselves.");
    return sentences.join(u' ');
}

QString changesSentence(const QString& name, const std::vector<Loss>& report)
{
    const auto remarks = std::ranges::count_if(report, &Loss::remark);
    const auto first = std::ranges::find_if(report, &Loss::remark);
    return remarks == 1 ? Text::tr("%1 was opened with a change: %2.").arg(name, counted(*first))
                        : Text::tr("%1 was opened with some changes, such as: %2.")
                              .arg(name, counted(*first));
}

QStringList lossLines(const std::vector<Loss>& report)
{
    QStringList lines;
    for (const Loss& loss : report)
        if (!loss.remark)
            lines << Text::tr("Lost: %1").arg(withPlace(loss))
                         + (loss.instead.isEmpty() ? QString()
                                                   : Text::tr("; %1").arg(loss.instead));
    for (const Loss& loss : report)
        if (loss.remark)
            lines << Text::tr("Changed: %1").arg(withPlace(loss));
    return lines;
}

QString whereText(const Loss& loss)
{
    if (loss.line <= 0)
        return {};
    return (loss.count == 1 ? Text::tr("line %1") : Text::tr("first in line %1")).arg(loss.line);
}

} // namespace app
