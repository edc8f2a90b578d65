// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/operations_view.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

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

constexpr int betweenCells = 12;

} // namespace

OperationsView::OperationsView(QWidget* parent) : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setAccessibleName(Text::tr("Operations so far"));
    show({}, {});
}

void OperationsView::show(const clipping::OperationCounts& now,
                          const clipping::OperationCounts& all)
{
    const struct {
        std::uint64_t now, all;
        QString word;
        bool always;
    } rows[]{{now.comparisons, all.comparisons, Text::tr("comparisons"), true},
             {now.additions, all.additions, Text::tr("additions"), true},
             {now.multiplications, all.multiplications, Text::tr("multiplications"), true},
             {now.divisions, all.divisions, Text::tr("divisions"), true},
             {now.negations, all.negations, Text::tr("negations"), false}};
    cells_.clear();
    QStringList words;
    for (const auto& row : rows)
        if (row.always || row.all > 0) {
            cells_.push_back({app::countText(row.now), app::countText(row.all),
                              Text::tr("of %1").arg(app::countText(row.all)), row.word});
            words << Text::tr("%1 of %2 %3").arg(cells_.back().now, cells_.back().all, row.word);
        }
    setAccessibleDescription(words.join(QStringLiteral(", ")));
    updateGeometry();
    update();
}

int OperationsView::widthOf(const Cell& cell) const
{
    const QFontMetrics caption(captionFont(font())), counter(counterFont(font()));
    return std::max(caption.horizontalAdvance(cell.word),
                    counter.horizontalAdvance(cell.all) + caption.horizontalAdvance(cell.of) + 6);
}

int OperationsView::cellHeight() const
{
    return QFontMetrics(counterFont(font())).height() + QFontMetrics(captionFont(font())).height()
           + 8;
}

/// The positions of the cells: in one row with equal gaps if they fit, else in several rows.
std::vector<QPoint> OperationsView::places(int width) const
{
    const int room = width - 2 * space::dockMargin;
    std::vector<QPoint> places;
    int x = 0, y = 0;
    for (const Cell& cell : cells_) {
        if (x > 0 && x + widthOf(cell) > room)
            x = 0, y += cellHeight();
        places.push_back({x, y});
        x += widthOf(cell) + betweenCells;
    }
    const int spare = std::max(0, room - x + betweenCells) / int(cells_.size());
    for (std::size_t i = 0; y == 0 && i < places.size(); ++i)
        places[i].rx() += int(i) * spare;
    return places;
}

int OperationsView::heightForWidth(int width) const
{
    return places(width).back().y() + cellHeight() + 12;
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
    const QFont counter = counterFont(font()), caption = captionFont(font());
    const QFontMetrics large(counter), small(caption);
    const auto where = places(width());
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const int x = space::dockMargin + where[i].x();
        const int base = 6 + where[i].y() + large.ascent();
        painter.setFont(counter);
        painter.setPen(look.text);
        painter.drawText(x, base, cells_[i].now);
        painter.setFont(caption);
        painter.setPen(look.muted);
        painter.drawText(x + large.horizontalAdvance(cells_[i].now) + 6, base, cells_[i].of);
        painter.drawText(x, base + large.descent() + small.ascent() + 2, cells_[i].word);
    }
}

} // namespace ui

#include "moc_operations_view.cpp"
