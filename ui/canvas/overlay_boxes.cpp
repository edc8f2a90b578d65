// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/overlay_boxes.h"

#include "app/base/numbers.h"
#include "app/overlays/label_places.h"
#include "ui/look/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {

using app::Emphasis;
using app::OverlayAxis;
using app::OverlayTable;

constexpr double boxInset = 10, padding = 8, columnGap = 14, bar = 3; // pixels
constexpr double widestCaption = 460, narrowestCaption = 170, tallest = 0.45;
// Sizes of the axis in multiples of the font's row height: its height, and the margin at either
// side.
constexpr double axisRows = 5.6, axisMarginRows = 7;

double rowHeight(const QFont& font) { return std::ceil(QFontMetricsF(font).height()) + 3; }

std::vector<double> columnWidths(const OverlayTable& table, const QFont& font)
{
    const QFontMetricsF metrics(semiBold(font));
    std::vector<double> widths(std::size_t(table.heading.size()), 0);
    const auto widen = [&](const QStringList& cells) {
        for (qsizetype i = 0; i < cells.size(); ++i)
            widths[std::size_t(i)] =
                std::max(widths[std::size_t(i)], std::ceil(metrics.horizontalAdvance(cells[i])));
    };
    widen(table.heading);
    for (const QStringList& row : table.rows)
        widen(row);
    return widths;
}

// Places the table at the top right, lower than half the height; of a longer table it shows the
// rows around the highlighted one. No table if it would leave no room for the sentence beside it,
// which is more important.
void placeTable(OverlayBoxes& boxes, const OverlayTable& table, const QRectF& room,
                const QFont& font)
{
    double width = 2 * padding + columnGap * double(table.heading.size() - 1);
    for (const double column : columnWidths(table, font))
        width += column;
    const double row = rowHeight(font), free = tallest * room.height() - 2 * padding - row;
    if (width > room.width() - boxInset - narrowestCaption || free < row)
        return;
    boxes.rows = std::min(table.rows.size(), std::size_t(free / row));
    const std::size_t middle = table.highlightedRow.value_or(0), half = boxes.rows / 2;
    boxes.firstRow = std::min(middle > half ? middle - half : 0, table.rows.size() - boxes.rows);
    const double height = 2 * padding + row * double(boxes.rows + 1);
    boxes.table = QRectF(room.right() - width, room.top(), width, height);
}

void placeCaption(OverlayBoxes& boxes, const QString& caption, const QRectF& room,
                  const QFont& font)
{
    const double right = boxes.table.isEmpty() ? room.right() : boxes.table.left() - boxInset;
    const double width = std::min(widestCaption, right - room.left());
    const QRectF text = QFontMetricsF(font).boundingRect(QRectF(0, 0, width - 2 * padding, 1e4),
                                                         Qt::TextWordWrap | Qt::AlignLeft, caption);
    const QRectF box(room.left(), room.top(), std::ceil(text.width()) + 2 * padding + 1,
                     std::ceil(text.height()) + 2 * padding - 4);
    if (box.bottom() <= room.bottom())
        boxes.caption = box;
}

void frame(QPainter& painter, const QRectF& box, const Look& look)
{
    QColor ground = look.panel;
    ground.setAlphaF(0.94F);
    painter.setPen(QPen(look.rule, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), space::radius, space::radius);
}

void paintRow(QPainter& painter, const QStringList& cells, const std::vector<double>& widths,
              QRectF line)
{
    for (qsizetype i = 0; i < cells.size(); ++i) {
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, cells[i]);
        line.setLeft(line.left() + widths[std::size_t(i)] + columnGap);
    }
}

void paintTable(QPainter& painter, const OverlayTable& table, const Look& look,
                const OverlayBoxes& boxes)
{
    frame(painter, boxes.table, look);
    const QFont font = painter.font();
    const auto widths = columnWidths(table, font);
    const double height = rowHeight(font);
    QRectF line = boxes.table.adjusted(padding, padding, -padding, 0);
    line.setHeight(height);
    painter.setPen(look.muted);
    paintRow(painter, table.heading, widths, line);
    for (std::size_t i = boxes.firstRow; i < boxes.firstRow + boxes.rows; ++i) {
        line.translate(0, height);
        const bool highlightedRow = table.highlightedRow == i;
        if (highlightedRow) {
            painter.fillRect(line.adjusted(1 - padding, 0, padding - 1, 0), look.tint);
            painter.fillRect(QRectF(boxes.table.left() + 1, line.top(), bar, height),
                             look.selection);
        }
        painter.setFont(highlightedRow ? semiBold(font) : font);
        painter.setPen(look.text);
        paintRow(painter, table.rows[i], widths, line);
    }
    painter.setFont(font);
}

/// The axis of t on the screen: from 0 to 1, extended a little if there are values beyond. Values
/// farther off are shown at its end.
class AxisScale {
public:
    AxisScale(const OverlayAxis& axis, const QRectF& box, double margin)
        : left_(box.left() + margin), right_(box.right() - margin)
    {
        for (const OverlayAxis::Tick& tick : axis.ticks) {
            low_ = std::min(low_, std::max(tick.t, -most));
            high_ = std::max(high_, std::min(tick.t, 1 + most));
        }
    }
    double at(double t) const
    {
        return left_ + (std::clamp(t, low_, high_) - low_) / (high_ - low_) * (right_ - left_);
    }
    double left() const { return left_; }
    double right() const { return right_; }
    bool isOff(double t) const { return t < low_ || t > high_; }

private:
    static constexpr double most = 0.6; // maximum extension beyond either end, in t
    double left_, right_, low_ = 0, high_ = 1;
};

void paintTick(QPainter& painter, const OverlayAxis::Tick& tick, const AxisScale& scale, double y,
               const OverlayGround& ground)
{
    const bool highlightedRow = tick.emphasis == Emphasis::Highlighted;
    const QColor colour = highlightedRow ? ground.look.selection : ground.look.muted;
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(tick.enters ? colour : ground.look.panel);
    const QPointF at(scale.at(tick.t), y);
    if (scale.isOff(tick.t)) { // an arrow: the value is farther off
        const double way = tick.t < 0 ? -5 : 5;
        painter.drawPolygon(
            QPolygonF{at + QPointF(way, 0), at + QPointF(-way, 4), at + QPointF(-way, -4)});
    } else
        painter.drawEllipse(at, 4, 4);
}

/// A label at the axis, above or below it.
struct AxisWord {
    QString text;
    double t;
    bool above, highlightedRow;
    bool end = false; ///< an end of the line: its label goes above or below, wherever there is room
};
// Entries are above, exits below; highlighted ones come first, then the ends of the line.
std::vector<AxisWord> axisWords(const OverlayAxis& axis)
{
    std::vector<AxisWord> words;
    const auto add = [&](Emphasis emphasis) {
        for (const OverlayAxis::Tick& tick : axis.ticks)
            if (tick.emphasis == emphasis)
                words.push_back({tick.edge + QStringLiteral("  ")
                                     + app::shortText(tick.t, app::parameterDigits),
                                 tick.t, tick.enters, emphasis == Emphasis::Highlighted});
    };
    add(Emphasis::Highlighted);
    for (const int end : {0, 1})
        for (const bool above : {false, true})
            words.push_back({QString::number(end), double(end), above, false, true});
    add(Emphasis::Quiet);
    return words;
}

// If two labels would overlap, the second is omitted.
void paintWords(QPainter& painter, const OverlayAxis& axis, const AxisScale& scale,
                const QRectF& box, const Look& look)
{
    const double y = box.center().y();
    const QFont font = painter.font();
    const double row = rowHeight(font);
    app::LabelPlaces places(box, {});
    std::array<bool, 2> ended{};
    for (const AxisWord& word : axisWords(axis)) {
        if (word.end && ended[std::size_t(word.t)])
            continue;
        painter.setFont(word.highlightedRow ? semiBold(font) : font);
        const QFontMetricsF metrics(painter.font());
        QRectF place(0, 0, metrics.horizontalAdvance(word.text) + 6, metrics.height());
        const double side = word.above ? -1 : 1;
        place.moveCenter({scale.at(word.t), y + side * row});
        place.moveLeft(std::clamp(place.left(), box.left() + 2, box.right() - 2 - place.width()));
        const auto free = places.first(std::array{place, place.translated(0, side * (row - 1))});
        if (!free)
            continue;
        painter.setPen(word.highlightedRow ? look.text : look.muted);
        painter.drawText(*free, Qt::AlignCenter, word.text);
        if (word.end)
            ended[std::size_t(word.t)] = true;
    }
    painter.setFont(font);
}

void paintAxis(QPainter& painter, const OverlayAxis& axis, const OverlayGround& ground,
               const QRectF& box)
{
    const Look& look = ground.look;
    frame(painter, box, look);
    const double row = rowHeight(painter.font()), wanted = axisMarginRows * row;
    const AxisScale scale(axis, box, std::min(wanted, box.width() / 5));
    const double y = box.center().y();
    painter.setPen(QPen(look.control, 1));
    painter.drawLine(QPointF(scale.left(), y), QPointF(scale.right(), y));
    for (const double end : {0.0, 1.0})
        painter.drawLine(QPointF(scale.at(end), y - 7), QPointF(scale.at(end), y + 7));
    if (axis.from <= axis.to) {
        painter.setPen(QPen(look.selection, 4, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(scale.at(axis.from), y),
                         QPointF(std::max(scale.at(axis.to), scale.at(axis.from) + 2), y));
    }
    for (const OverlayAxis::Tick& tick : axis.ticks)
        paintTick(painter, tick, scale, y, ground);
    paintWords(painter, axis, scale, box, look);
    painter.setPen(look.muted);
    if (scale.left() - box.left() < wanted)
        return; // no room for the caption at the line
    QRectF line(box.left() + padding, y - 1.5 * row, wanted, row);
    for (const QString& word : {Text::tr("enters"), Text::tr("t"), Text::tr("leaves")}) {
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, word);
        line.translate(0, row);
    }
}

} // namespace

OverlayBoxes boxesOf(const app::Overlay& overlay, const OverlayGround& ground, const QFont& font)
{
    OverlayBoxes boxes;
    QRectF room = ground.room.adjusted(boxInset, boxInset, -boxInset, -boxInset);
    const double axisHeight = axisRows * rowHeight(font);
    if (overlay.axis && room.height() > 3 * axisHeight && room.width() > 3 * axisHeight) {
        boxes.axis = QRectF(room.left(), room.bottom() - axisHeight, room.width(), axisHeight);
        room.setBottom(boxes.axis.top() - boxInset);
    }
    if (overlay.table)
        placeTable(boxes, *overlay.table, room, font);
    if (!overlay.caption.isEmpty())
        placeCaption(boxes, overlay.caption, room, font);
    return boxes;
}

void paintBoxes(QPainter& painter, const app::Overlay& overlay, const OverlayGround& ground,
                const OverlayBoxes& boxes)
{
    if (!boxes.axis.isEmpty())
        paintAxis(painter, *overlay.axis, ground, boxes.axis);
    if (!boxes.table.isEmpty())
        paintTable(painter, *overlay.table, ground.look, boxes);
    if (boxes.caption.isEmpty())
        return;
    frame(painter, boxes.caption, ground.look);
    painter.setPen(ground.look.text);
    painter.drawText(boxes.caption.adjusted(padding, padding - 2, -padding + 1, 0),
                     Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop, overlay.caption);
}

} // namespace ui
