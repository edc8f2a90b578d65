// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/sheet_painter.h"

#include "app/tiles/marks.h"
#include "app/view/outline.h"
#include "ui/look/text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr double leastMarks = 5; // pixels of a margin; marks in narrower ones would be specks
constexpr double leastTag = 26;  // pixels of a sheet's side, for its name
constexpr int tagHeight = 16, tagMargin = 7, smallMargin = 3;

/// The band that two sheets share lies under the drawing.
QColor overlapTint(const Look& look)
{
    QColor tint = look.accent;
    tint.setAlphaF(look.dark ? 0.16F : 0.10F);
    return tint;
}

} // namespace

SheetPainter::SheetPainter(QPainter& painter, const app::LiveSheets& sheets,
                           const app::SheetLayout& layout, const app::View& view, const Look& look)
    : painter_(painter), sheets_(sheets), layout_(layout), view_(view), look_(look),
      tiling_(*sheets.tiling().value)
{
}

QRectF SheetPainter::onScreen(const clipping::Window& window) const
{
    const app::Point from = view_.toScreen(window.min), to = view_.toScreen(window.max);
    return {QPointF(from.x, from.y), QPointF(to.x, to.y)};
}

void SheetPainter::paintPapers(bool tinted)
{
    const bool apart = layout_.arrangement == app::SheetArrangement::Apart;
    if (!apart) {
        const double unit = layout_.millimetresPerUnit;
        const clipping::Window page = sheets_.drawing().page().rectangle();
        painter_.fillRect(onScreen({page.min * unit, page.max * unit}), look_.paper);
    }
    for (std::size_t i = 0; i < layout_.places.size(); ++i) {
        const auto& [part, paper, offset] = layout_.places[i];
        if (apart)
            painter_.fillRect(onScreen(paper), look_.paper);
        if (tinted && !tiling_.tiles[i].leftOut)
            paintOverlaps(tiling_.tiles[i], part);
        if (!apart)
            continue;
        painter_.setPen(QPen(look_.border, 1));
        painter_.drawRect(onScreen(paper));
    }
}

/// In place, each band belongs to two sheets and is painted once.
void SheetPainter::paintOverlaps(const app::Tile& tile, const clipping::Window& part)
{
    const double width = tiling_.overlap * layout_.millimetresPerUnit;
    const bool apart = layout_.arrangement == app::SheetArrangement::Apart;
    const QColor tint = overlapTint(look_);
    const auto band = [&](const app::Point& min, const app::Point& max) {
        painter_.fillRect(onScreen({min, max}), tint);
    };
    if (width <= 0)
        return;
    if (apart && tile.column > 1)
        band(part.min, {part.min.x + width, part.max.y});
    if (tile.column < tiling_.columns)
        band({part.max.x - width, part.min.y}, part.max);
    if (apart && tile.row > 1)
        band(part.min, {part.max.x, part.min.y + width});
    if (tile.row < tiling_.rows)
        band({part.min.x, part.max.y - width}, part.max);
}

/// A picture that is up to date consists of the device's pixels; an older one is moved and scaled.
void SheetPainter::paintPictures(const std::vector<SheetArt::Picture>& pictures)
{
    const double ratio = painter_.device()->devicePixelRatioF();
    painter_.setRenderHint(QPainter::SmoothPixmapTransform);
    for (const auto& [sheet, drawn, image] : pictures) {
        if (sheet >= layout_.places.size())
            continue;
        QRectF place =
            onScreen({layout_.toLayout(sheet, drawn.min), layout_.toLayout(sheet, drawn.max)});
        if (std::abs(place.width() * ratio - image.width()) < 0.5
            && std::abs(place.height() * ratio - image.height()) < 0.5)
            place = {std::round(place.x() * ratio) / ratio, std::round(place.y() * ratio) / ratio,
                     image.width() / ratio, image.height() / ratio};
        painter_.drawImage(place, image);
    }
}

void SheetPainter::paintEdges()
{
    painter_.setBrush(Qt::NoBrush);
    const bool apart = layout_.arrangement == app::SheetArrangement::Apart;
    for (const bool leftOut : {true, false}) // those that are cut lie over those that are not
        for (std::size_t i = 0; i < layout_.places.size(); ++i) {
            if (tiling_.tiles[i].leftOut != leftOut)
                continue;
            const QRectF part = onScreen(layout_.places[i].part);
            if (leftOut && apart) {
                QColor veil = look_.canvas;
                veil.setAlphaF(0.72F);
                painter_.fillRect(onScreen(layout_.places[i].paper), veil);
            }
            painter_.setPen(QPen(leftOut ? look_.border : look_.accent, 1,
                                 leftOut ? Qt::DashLine : Qt::SolidLine));
            painter_.drawRect(part);
        }
}

void SheetPainter::paintMarks()
{
    const double margin = sheets_.settings().plan.margin * view_.zoom;
    if (layout_.arrangement != app::SheetArrangement::Apart || margin < leastMarks)
        return;
    const QRectF all(0, 0, view_.size.x, view_.size.y);
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < layout_.places.size(); ++i)
        if (const QRectF paper = onScreen(layout_.places[i].paper);
            paper.intersects(all) && !tiling_.tiles[i].leftOut)
            paintMarksOf(i, paper);
    painter_.restore();
}

void SheetPainter::paintMarksOf(std::size_t sheet, const QRectF& paper)
{
    painter_.setClipRect(paper);
    const double zoom = layout_.millimetresPerUnit * view_.zoom;
    const app::Point corner = view_.toScreen(layout_.places[sheet].offset);
    const QTransform place(zoom, 0, 0, zoom, corner.x, corner.y);
    for (const app::Object& mark :
         app::marksOf(tiling_, tiling_.tiles[sheet], sheets_.settings().plan, sheets_.title())) {
        painter_.setPen(QPen(look_.text, std::max(0.75, mark.style.width * zoom)));
        painter_.drawPath(place.map(app::painterPath(mark.path, mark.style.fillRule)));
    }
}

void SheetPainter::paintTags(const QFont& font, bool large)
{
    const QRectF all(0, 0, view_.size.x, view_.size.y);
    for (std::size_t i = 0; i < layout_.places.size(); ++i)
        if (onScreen(layout_.places[i].paper).adjusted(0, -2 * tagHeight, 0, 0).intersects(all))
            paintTag(i, font, large);
}

/// Above the sheet if there is room between the sheets; otherwise in its corner. An overview has
/// only numbers, in the middles.
void SheetPainter::paintTag(std::size_t sheet, const QFont& font, bool large)
{
    const app::Tile& tile = tiling_.tiles[sheet];
    const QRectF paper = onScreen(layout_.places[sheet].paper);
    if (paper.width() < leastTag || paper.height() < leastTag)
        return;
    painter_.setFont(semiBold(font));
    const QFontMetricsF metrics(painter_.font());
    const QString name = QStringLiteral("%1-%2").arg(tile.row).arg(tile.column);
    const double height = std::max<double>(tagHeight, metrics.height() + 2);
    QRectF tag(0, 0, metrics.horizontalAdvance(name) + 2 * (large ? tagMargin : smallMargin),
               height);
    const double gap = (layout_.bounds.max.y - layout_.bounds.min.y) * view_.zoom;
    const bool above =
        layout_.arrangement == app::SheetArrangement::Apart && large
        && (tiling_.rows == 1
            || (gap - paper.height() * tiling_.rows) / (tiling_.rows - 1) > height + 6);
    if (above)
        tag.moveBottomLeft(paper.topLeft() - QPointF(0, 4));
    else if (large)
        tag.moveTopLeft(paper.topLeft() + QPointF(4, 4));
    else
        tag.moveCenter(paper.center());
    if (!large && tag.width() > paper.width())
        return;
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(tile.leftOut ? look_.muted : look_.accent);
    painter_.drawRoundedRect(tag, space::radius - 1, space::radius - 1);
    painter_.setPen(tile.leftOut ? look_.panel : look_.onAccent);
    painter_.drawText(tag, Qt::AlignCenter, name);
    const QString remark = tile.empty     ? Text::tr("empty, left out")
                           : tile.leftOut ? Text::tr("left out")
                                          : app::paperText(sheets_.settings(), tiling_);
    painter_.setFont(font);
    const double room = paper.right() - tag.right() - 8;
    if (!above || QFontMetricsF(font).horizontalAdvance(remark) > room)
        return;
    painter_.setPen(look_.muted);
    painter_.drawText(QRectF(tag.right() + 8, tag.top(), room, height),
                      Qt::AlignLeft | Qt::AlignVCenter, remark);
}

} // namespace ui
