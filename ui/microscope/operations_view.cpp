// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/operations_view.h"

#include "app/view/numbers.h"
#include "ui/look.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

QFont counterFont(const QFont& body)
{
    QFont font = semiBold(body);
    if (body.pixelSize() > 0)
        font.setPixelSize(qRound(body.pixelSize() * 1.7));
    else
        font.setPointSizeF(body.pointSizeF() * 1.7);
    return font;
}

constexpr int gap = 12;

} // namespace

OperationsView::OperationsView(QWidget* parent) : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setAccessibleName(tr("Operations so far"));
    show({}, {});
}

void OperationsView::show(const clipping::OperationCounts& now,
                          const clipping::OperationCounts& all)
{
    const struct {
        std::uint64_t now, all;
        QString word;
        bool always;
    } rows[]{{now.comparisons, all.comparisons, tr("comparisons"), true},
             {now.additions, all.additions, tr("+ and \u2212"), true},
             {now.multiplications, all.multiplications, tr("multiplications"), true},
             {now.divisions, all.divisions, tr("divisions"), true},
             {now.negations, all.negations, tr("sign changes"), false}};
    cells_.clear();
    QStringList words;
    for (const auto& row : rows)
        if (row.always || row.all > 0) {
            cells_.push_back(
                {app::countText(row.now), tr("of %1").arg(app::countText(row.all)), row.word});
            words << tr("%1 of %2 %3").arg(cells_.back().now, app::countText(row.all), row.word);
        }
    setAccessibleDescription(words.join(QStringLiteral(", ")));
    updateGeometry();
    update();
}

int OperationsView::cellWidth() const
{
    const QFontMetrics caption(captionFont(font())), counter(counterFont(font()));
    int widest = 0;
    for (const Cell& cell : cells_)
        widest = std::max(
            {widest, caption.horizontalAdvance(cell.word),
             counter.horizontalAdvance(cell.now) + 6 + caption.horizontalAdvance(cell.all)});
    return widest + gap;
}

int OperationsView::cellHeight() const
{
    return QFontMetrics(counterFont(font())).height() + QFontMetrics(captionFont(font())).height()
           + 8;
}

int OperationsView::columnsIn(int width) const
{
    const int fitting = (width - space::dockMargin) / std::max(1, cellWidth());
    return std::clamp(fitting, 1, int(cells_.size()));
}

int OperationsView::heightForWidth(int width) const
{
    const int columns = columnsIn(width);
    return (int(cells_.size()) + columns - 1) / columns * cellHeight() + 12;
}

QSize OperationsView::minimumSizeHint() const
{
    return {200, heightForWidth(std::max(width(), 200))};
}
QSize OperationsView::sizeHint() const { return {420, heightForWidth(std::max(width(), 200))}; }

void OperationsView::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    const int columns = columnsIn(width());
    const int step = (width() - space::dockMargin) / columns;
    const QFont counter = counterFont(font()), caption = captionFont(font());
    const QFontMetrics large(counter), small(caption);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const int x = space::dockMargin + int(i) % columns * step;
        const int base = 6 + int(i) / columns * cellHeight() + large.ascent();
        painter.setFont(counter);
        painter.setPen(look.text);
        painter.drawText(x, base, cells_[i].now);
        painter.setFont(caption);
        painter.setPen(look.muted);
        painter.drawText(x + large.horizontalAdvance(cells_[i].now) + 6, base, cells_[i].all);
        painter.drawText(x, base + large.descent() + small.ascent() + 2, cells_[i].word);
    }
}

} // namespace ui
