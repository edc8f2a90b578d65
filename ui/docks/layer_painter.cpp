// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layer_painter.h"

#include "app/base/numbers.h"
#include "ui/docks/algorithm_list.h"
#include "ui/docks/layer_list.h"
#include "ui/widgets/tabular.h"

#include <QMouseEvent>

#include <algorithm>
#include <optional>

namespace ui {
namespace {

using Model = LayerModel;

// Pixels; deeper levels are not indented further.
constexpr int indent = 14, deepest = 8, besideEye = 20, chevronWidth = 14, besideCount = 38;

int leftOf(const QRect& row, const QModelIndex& index)
{
    return LayerPainter::leftOf(row, index.data(Model::DepthRole).toInt());
}

QRect chevron(const QRect& row, const QModelIndex& index)
{
    return {leftOf(row, index), row.center().y() - 7, chevronWidth, 14};
}

QRect swatch(const QRect& row, const QModelIndex& index)
{
    return {leftOf(row, index) + chevronWidth + 2, row.center().y() - 5, 12, 12};
}

QRect lock(const QRect& row)
{
    return {row.right() - space::dockMargin - 15, row.center().y() - 7, 16, 16};
}

QRect nameBox(const QRect& row, const QModelIndex& index)
{
    const bool counts = index.data(Model::CountRole).isValid();
    return {QPoint(swatch(row, index).right() + 9, row.top()),
            QPoint(row.right() - (counts ? 90 : space::dockMargin), row.bottom())};
}

/// All but the row that shows more.
bool hasEye(const QModelIndex& index)
{
    return index.data(Model::CountRole).isValid() || index.data(Model::IconRole).isValid();
}

void drawChevron(QPainter& painter, const QRect& box, bool open, const QColor& colour)
{
    const QPointF middle = QRectF(box).center();
    constexpr double half = 3.5, flat = 2;
    const QPolygonF shape =
        open ? QPolygonF{middle + QPointF(-half, -flat), middle + QPointF(0, flat),
                         middle + QPointF(half, -flat)}
             : QPolygonF{middle + QPointF(-flat, -half), middle + QPointF(flat, 0),
                         middle + QPointF(-flat, half)};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5));
    painter.drawPolyline(shape);
    painter.restore();
}

void drawKind(QPainter& painter, const QRect& row, const QModelIndex& index, const Look& look)
{
    const QRect square = swatch(row, index);
    if (const QString key = index.data(Model::IconRole).toString(); !key.isEmpty()) {
        icon(key.toStdString()).paint(&painter, square.adjusted(-1, -1, 1, 1));
    } else if (index.data(Model::CountRole).isValid()) {
        if (const auto colour = index.data(Qt::DecorationRole).value<QColor>(); colour.isValid())
            painter.fillRect(square, colour);
        painter.setPen(look.control); // a colour may be that of the row
        painter.drawRect(square.adjusted(0, 0, -1, -1));
    }
}

void drawLock(QPainter& painter, const QRect& row, const QModelIndex& index, bool locked)
{
    const bool pen = index.data(Model::PenRole).toBool();
    icon(locked ? "lock"
         : pen  ? "pencil"
                : "unlock")
        .paint(&painter, lock(row), Qt::AlignCenter,
               locked || pen ? QIcon::Normal : QIcon::Disabled);
}

/// What the row says by its ground: it is selected, or holds a part of the selection.
QStyleOptionViewItem grounded(QStyleOptionViewItem option, const QModelIndex& index)
{
    option.state.setFlag(QStyle::State_Selected, index.data(Model::SelectedRole).toBool());
    if (index.data(Model::PenRole).toBool())
        option.font = semiBold(option.font);
    return option;
}

} // namespace

int LayerPainter::leftOf(const QRect& row, int depth)
{
    return row.left() + space::dockMargin + besideEye + std::min(depth - 1, deepest) * indent;
}

LayerPainter::LayerPainter(LayerList& list) : RowPainter(&list), list_(list) {}

void LayerPainter::paint(QPainter* painter, const QStyleOptionViewItem& given,
                         const QModelIndex& index) const
{
    const QStyleOptionViewItem option = grounded(given, index);
    const Look& look = lookOf(option.palette);
    if (index.data(Model::HoldsRole).toBool()) {
        QColor tint = look.tint;
        tint.setAlphaF(0.5F);
        painter->fillRect(option.rect, tint);
    }
    drawRowGround(*painter, option);
    const QVariant count = index.data(Model::CountRole);
    const auto marked = [&](int role) {
        return list_.sweptAs(index, role).value_or(index.data(role).toBool());
    };
    const bool visible = marked(Model::VisibleRole);
    if (hasEye(index))
        drawEye(*painter, option.rect, visible);
    if (count.isValid())
        drawLock(*painter, option.rect, index, marked(Model::LockedRole));
    if (const QVariant open = index.data(Model::OpenRole); open.isValid())
        drawChevron(*painter, chevron(option.rect, index), open.toBool(), look.muted);
    drawKind(*painter, option.rect, index, look);
    drawName(*painter, option, nameBox(option.rect, index), index.data().toString(), !visible);
    if (!count.isValid())
        return;
    painter->setPen(look.muted);
    painter->setFont(captionFont(option.font));
    drawTabular(*painter, option.rect.adjusted(0, 0, -besideCount, 0),
                Qt::AlignRight | Qt::AlignVCenter, app::countText(count.toULongLong()));
}

void LayerPainter::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex& index) const
{
    editor->setGeometry(nameBox(option.rect, index));
}

std::optional<int> LayerPainter::markAt(const QRect& row, const QModelIndex& index,
                                        const QPoint& at)
{
    if (hasEye(index) && hits(eye(row), at))
        return Model::VisibleRole;
    if (index.data(Model::CountRole).isValid() && hits(lock(row), at))
        return Model::LockedRole;
    return std::nullopt;
}

bool LayerPainter::hitsSign(const QRect& row, const QModelIndex& index, const QPoint& at)
{
    return markAt(row, index, at)
           || (index.data(Model::OpenRole).isValid() && hits(chevron(row, index), at));
}

bool LayerPainter::editorEvent(QEvent* event, QAbstractItemModel* model,
                               const QStyleOptionViewItem& option, const QModelIndex& index)
{
    if (event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto& mouse = *static_cast<QMouseEvent*>(event);
    const QPoint at = mouse.position().toPoint();
    if (mouse.button() != Qt::LeftButton)
        return false;
    auto& layers = *static_cast<LayerModel*>(model);
    if (const QVariant open = index.data(Model::OpenRole);
        open.isValid() && chevron(option.rect, index).adjusted(-3, -6, 1, 6).contains(at)) {
        layers.setOpen(index, !open.toBool());
        return true;
    }
    const auto mark = markAt(option.rect, index, at);
    const bool isContainer = index.data(Model::CountRole).isValid();
    if (isContainer && mark == Model::VisibleRole && mouse.modifiers() & Qt::AltModifier) {
        layers.showOnly(index);
        return true;
    }
    if (mark)
        return model->setData(index, !index.data(*mark).toBool(), *mark);
    if (list_.layerOf(index) != 0 && hits(swatch(option.rect, index), at)) {
        emit list_.colourWanted(list_.layerOf(index));
        return true;
    }
    return false;
}

} // namespace ui
