// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/cut_text.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <QStringList>

namespace app {

namespace {

void addCount(QString& text, std::size_t count, const char* sentence)
{
    if (count > 0)
        text += u' ' + Text::tr(sentence).arg(countText(count));
}

} // namespace

QString cutText(const CutCounts& counts)
{
    QStringList parts;
    const auto add = [&](std::size_t count, const char* text) {
        if (count > 0)
            parts << Text::tr(text).arg(countText(count));
    };
    const auto addFirst = [&](std::size_t count, const char* one, const char* many,
                              const char* further) {
        add(count, !parts.isEmpty() ? further : count == 1 ? one : many);
    };
    addFirst(counts.whole, QT_TRANSLATE_NOOP("Text", "%1 object kept whole"),
             QT_TRANSLATE_NOOP("Text", "%1 objects kept whole"),
             QT_TRANSLATE_NOOP("Text", "%1 kept whole"));
    addFirst(counts.cut, QT_TRANSLATE_NOOP("Text", "%1 object cut"),
             QT_TRANSLATE_NOOP("Text", "%1 objects cut"), QT_TRANSLATE_NOOP("Text", "%1 cut"));
    addFirst(counts.gone, QT_TRANSLATE_NOOP("Text", "%1 object left out"),
             QT_TRANSLATE_NOOP("Text", "%1 objects left out"),
             QT_TRANSLATE_NOOP("Text", "%1 left out"));
    addFirst(counts.touching,
             QT_TRANSLATE_NOOP("Text", "%1 object that only touches the window left out"),
             QT_TRANSLATE_NOOP("Text", "%1 objects that only touch the window left out"),
             QT_TRANSLATE_NOOP("Text", "%1 that only touch it left out"));
    QString text =
        parts.isEmpty() ? Text::tr("there was nothing to cut.") : parts.join(Text::tr(", ")) + u'.';
    addCount(text, counts.opened, QT_TRANSLATE_NOOP("Text", "Closed shapes cut open: %1."));
    addCount(text, counts.imagesCut, QT_TRANSLATE_NOOP("Text", "Images cut: %1."));
    addCount(text, counts.imagesGone, QT_TRANSLATE_NOOP("Text", "Images removed: %1."));
    addCount(text, counts.imagesUncut,
             QT_TRANSLATE_NOOP("Text", "Images not cut along the windows, only at the rectangle "
                                       "around them: %1."));
    addCount(text, counts.imagesWhole,
             QT_TRANSLATE_NOOP("Text", "Images kept whole, because only their outside can be cut "
                                       "off: %1."));
    addCount(text, counts.dropped, QT_TRANSLATE_NOOP("Text", "Short pieces dropped: %1."));
    addCount(text, counts.fillsRemoved, QT_TRANSLATE_NOOP("Text", "Fills removed: %1."));
    addCount(text, counts.slanted,
             QT_TRANSLATE_NOOP("Text", "Wide strokes that do not end along a slanted edge: %1. "
                                       "With “Outline of stroke” before the cut they do."));
    addCount(text, counts.hidden, QT_TRANSLATE_NOOP("Text", "Still hidden: %1."));
    return text + leftAloneText(counts);
}

QString leftAloneText(const CutCounts& counts)
{
    QString text;
    addCount(text, counts.leftLocked, QT_TRANSLATE_NOOP("Text", "Unchanged on locked layers: %1."));
    addCount(text, counts.leftHidden, QT_TRANSLATE_NOOP("Text", "Unchanged because hidden: %1."));
    return text;
}

} // namespace app
