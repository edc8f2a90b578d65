// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/loss_text.h"

#include "app/base/numbers.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("losses", text); }

QString counted(const Loss& loss)
{
    return tr("%1 %2").arg(countText(std::size_t(loss.count)), loss.what);
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
    const QString list = lost.isEmpty() ? last : tr("%1 and %2").arg(lost.join(tr(", ")), last);
    return tr("%1 cannot be kept.").arg(list);
}

QStringList lossLines(const std::vector<Loss>& report)
{
    QStringList lines;
    for (const Loss& loss : report)
        if (!loss.remark)
            lines << tr("Lost: %1").arg(counted(loss))
                         + (loss.instead.isEmpty() ? QString() : tr("; %1").arg(loss.instead));
    for (const Loss& loss : report)
        if (loss.remark)
            lines << tr("Changed: %1").arg(counted(loss));
    return lines;
}

} // namespace app
