// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/difference_overlay.h"

#include "app/base/numbers.h"
#include "app/session/window_in_hand.h"
#include "app/session/window_words.h"
#include "ui/canvas/left_alone_mark.h"
#include "ui/look/text.h"

namespace ui {

namespace {

constexpr double inset = 10, margin = 10, sample = 22, besideSample = 8,
                 sampleWidth = 2.25; // pixels
constexpr double boxHeight = 26;

struct Words {
    QString whole, brief;
};

Words countedWords(const app::DifferenceCounts& counts)
{
    QStringList whole, brief;
    const auto add = [&](std::size_t count, const QString& one, const QString& many,
                         const QString& word) {
        if (count == 0)
            return;
        const QString number = app::countText(count);
        whole << (count == 1 ? one : many.arg(number));
        brief << word.arg(number);
    };
    add(counts.onlyB, Text::tr("1 visible line lost"), Text::tr("%1 visible lines lost"),
        Text::tr("%1 lost"));
    add(counts.onlyA, Text::tr("1 invisible line kept"), Text::tr("%1 invisible lines kept"),
        Text::tr("%1 kept wrongly"));
    add(counts.endsApart, Text::tr("1 line misplaced"), Text::tr("%1 lines misplaced"),
        Text::tr("%1 misplaced"));
    return {whole.join(Text::tr(", ")), brief.join(Text::tr(", "))};
}

/// What the label of a pane says; empty: nothing.
Words labelOf(const Controller& controller, const Pane& pane)
{
    const app::Session& session = controller.session();
    if (pane.among == 1)
        return {};
    if (const QString limit = app::limitText(pane.choice, app::needsOf(session.region()));
        !limit.isEmpty() && !hasReasons(pane))
        return {Text::tr("Not clipped here: %1").arg(limit), Text::tr("Not clipped here")};
    const auto differences = controller.frames().differing(pane);
    if (!differences || differences->list.empty())
        return {};
    Words words = countedWords(app::counted(differences->list));
    if (const QString name = app::comparedName(session); !name.isEmpty())
        words.whole =
            Text::tr("%1 in %2", "lines that differ, a clip window").arg(words.whole, name);
    return words;
}

/// A piece of a differing line, with the tick that it has on dark paper.
void paintSample(QPainter& painter, const Look& look, double left, double middle)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.differs, sampleWidth, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(left, middle), QPointF(left + sample, middle));
    if (look.dark)
        painter.drawLine(QPointF(left + sample / 2, middle - 4),
                         QPointF(left + sample / 2, middle + 4));
}

} // namespace

double differenceLabelHeight(const Controller& controller, const Pane& pane)
{
    return labelOf(controller, pane).whole.isEmpty() ? 0 : boxHeight + inset;
}

void paintDifferenceLabel(QPainter& painter, const Controller& controller, const Pane& pane)
{
    const Words words = labelOf(controller, pane);
    if (words.whole.isEmpty())
        return;
    const Look& look = controller.paperLook();
    const bool differs = controller.frames().differing(pane) != nullptr;
    const app::Point room = controller.view().size;
    const QFontMetricsF metrics(painter.font());
    const double before = differs ? sample + besideSample : 0;
    const double around = 2 * inset + 2 * margin + before;
    QString text = words.whole;
    if (metrics.horizontalAdvance(text) > room.x - around)
        text = metrics.elidedText(words.brief, Qt::ElideRight, room.x - around);
    const QRectF box(inset, room.y - inset - boxHeight,
                     metrics.horizontalAdvance(text) + 2 * margin + before, boxHeight);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(box, look.base);
    painter.setPen(differs ? look.differs : look.border);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    if (differs)
        paintSample(painter, look, box.left() + margin, box.center().y());
    painter.setPen(differs ? look.text : look.muted);
    painter.drawText(box.adjusted(margin + before, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
}

} // namespace ui
