// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/legend.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/microscope/timeline.h"

#include <algorithm>

namespace ui {

namespace {

constexpr int sign = 20, betweenSigns = 14; // pixels

} // namespace

Legend::Legend(QWidget* parent) : QWidget(parent)
{
    setFont(captionFont(font()));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(Text::tr("Signs of the timeline"));
}

void Legend::show(const app::Narration& narration)
{
    std::vector<app::Mark> marks;
    for (const app::NarratedStep& narrated : narration.steps)
        if (std::ranges::find(marks, narrated.mark) == marks.end())
            marks.push_back(narrated.mark);
    std::ranges::sort(marks);
    if (marks == marks_)
        return;
    marks_ = std::move(marks);
    updateGeometry();
    update();
}

QSize Legend::sizeHint() const
{
    int width = 0;
    for (const app::Mark mark : marks_)
        width += sign + fontMetrics().horizontalAdvance(markWord(mark)) + betweenSigns;
    return {width, std::max(18, fontMetrics().height())};
}

void Legend::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    double x = 0;
    for (const app::Mark mark : marks_) {
        const QString word = markWord(mark);
        paintMark(painter, QPointF(x + 7, height() / 2.0), mark, look.muted, look.panel);
        painter.setPen(look.muted);
        painter.drawText(QRectF(x + sign, 0, 200, height()), Qt::AlignLeft | Qt::AlignVCenter,
                         word);
        x += sign + fontMetrics().horizontalAdvance(word) + betweenSigns;
    }
}

} // namespace ui

#include "moc_legend.cpp"
