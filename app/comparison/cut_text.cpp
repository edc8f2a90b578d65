// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/cut_text.h"

#include "app/base/numbers.h"

#include <QCoreApplication>
#include <QStringList>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("cut", text); }

void addCount(QString& text, std::size_t count, const char* sentence)
{
    if (count > 0)
        text += u' ' + tr(sentence).arg(countText(count));
}

} // namespace

QString cutText(const CutCounts& counts)
{
    QStringList parts;
    const auto add = [&](std::size_t count, const char* text) {
        if (count > 0)
            parts << tr(text).arg(countText(count));
    };
    const auto addFirst = [&](std::size_t count, const char* one, const char* many,
                              const char* further) {
        add(count, !parts.isEmpty() ? further : count == 1 ? one : many);
    };
    addFirst(counts.whole, "%1 object kept whole", "%1 objects kept whole", "%1 kept whole");
    addFirst(counts.cut, "%1 object cut", "%1 objects cut", "%1 cut");
    addFirst(counts.gone, "%1 object left out", "%1 objects left out", "%1 left out");
    addFirst(counts.touching, "%1 object that only touches the window left out",
             "%1 objects that only touch the window left out", "%1 that only touch it left out");
    QString text = parts.isEmpty() ? tr("there was nothing to cut.") : parts.join(tr(", ")) + u'.';
    addCount(text, counts.opened, "Closed shapes cut open: %1.");
    addCount(text, counts.dropped, "Short pieces dropped: %1.");
    addCount(text, counts.fillsRemoved, "Fills removed: %1.");
    addCount(text, counts.hidden, "Still hidden: %1.");
    return text + leftAloneText(counts);
}

QString leftAloneText(const CutCounts& counts)
{
    QString text;
    addCount(text, counts.leftLocked, "Unchanged on locked layers: %1.");
    addCount(text, counts.leftHidden, "Unchanged because hidden: %1.");
    return text;
}

} // namespace app
