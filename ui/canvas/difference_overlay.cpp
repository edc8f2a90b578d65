// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/difference_overlay.h"

#include "app/base/numbers.h"

#include <QCoreApplication>

namespace ui {

namespace {

constexpr double inset = 10, margin = 10, sample = 22, gap = 8, sampleWidth = 2.25; // pixels
constexpr double height = 26;

struct Words {
    QString whole, brief;
};

Words wordsOf(const app::DifferenceCounts& counts)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("Canvas", text); };
    QStringList whole, brief;
    const auto add = [&](std::size_t count, const QString& one, const QString& many,
                         const QString& word) {
        if (count == 0)
            return;
        const QString number = app::countText(count);
        whole << (count == 1 ? one : many.arg(number));
        brief << word.arg(number);
    };
    add(counts.onlyB, tr("1 visible line lost"), tr("%1 visible lines lost"), tr("%1 lost"));
    add(counts.onlyA, tr("1 invisible line kept"), tr("%1 invisible lines kept"),
        tr("%1 kept wrongly"));
    add(counts.endsApart, tr("1 line misplaced"), tr("%1 lines misplaced"), tr("%1 misplaced"));
    return {whole.join(tr(", ")), brief.join(tr(", "))};
}

} // namespace

double differenceLabelHeight(const Controller& controller, const Pane& pane)
{
    const auto differences = controller.differing(pane);
    return differences && !differences->list.empty() ? height + inset : 0;
}

void paintDifferenceLabel(QPainter& painter, const Controller& controller, const Pane& pane)
{
    const auto differences = controller.differing(pane);
    if (!differences || differences->list.empty())
        return;
    const Look& look = controller.look();
    const app::Point room = controller.view().size;
    const QFontMetricsF metrics(painter.font());
    const double around = 2 * inset + 2 * margin + sample + gap;
    const Words words = wordsOf(app::counted(differences->list));
    QString text = words.whole;
    if (metrics.horizontalAdvance(text) > room.x - around)
        text = metrics.elidedText(words.brief, Qt::ElideRight, room.x - around);
    const QRectF box(inset, room.y - inset - height,
                     metrics.horizontalAdvance(text) + 2 * margin + sample + gap, height);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(box, look.base);
    painter.setPen(look.differs);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.differs, sampleWidth, Qt::SolidLine, Qt::FlatCap));
    const double middle = box.center().y(), left = box.left() + margin;
    painter.drawLine(QPointF(left, middle), QPointF(left + sample, middle));
    if (look.dark) // like the lines themselves
        painter.drawLine(QPointF(left + sample / 2, middle - 4),
                         QPointF(left + sample / 2, middle + 4));
    painter.setPen(look.text);
    painter.drawText(box.adjusted(margin + sample + gap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
}

} // namespace ui
