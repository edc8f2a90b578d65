// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/rearrange_selection.h"
#include "ui/docks/layer_list.h"
#include "ui/docks/layer_painter.h"
#include "ui/look/look.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include <utility>

// The pointer in the list of layers: clicks, and what is dragged.

namespace ui {

void LayerList::mousePressEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    const QModelIndex index = indexAt(at);
    pressed_.reset();
    if (event->button() == Qt::LeftButton && index.isValid())
        pressed_ = Press{at, index};
    if (pressed_ && LayerPainter::hitsSign(visualRect(index), index, at)) {
        pressed_->onSign = true; // an eye, say: the layer is not chosen
        return;
    }
    QListView::mousePressEvent(event);
    if (!pressed_ || layers_->layerOf(index) != 0)
        return;
    // Several that are selected may be dragged together; one of them is selected at the release.
    pressed_->picksAtRelease =
        event->modifiers() == Qt::NoModifier && index.data(LayerModel::SelectedRole).toBool();
    pressed_->showsMore = layers_->rowAt(index)->kind == app::TreeRow::Kind::More;
    if (!pressed_->picksAtRelease)
        pick(index, event->modifiers());
}

void LayerList::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    if (pressed_ && pressed_->onSign)
        return;
    if (pressed_ && dragged_ == 0 && !dragsObjects_
        && (at - pressed_->at).manhattanLength() >= QApplication::startDragDistance())
        startDrag();
    if (dragged_ == 0 && !dragsObjects_)
        return QListView::mouseMoveEvent(event);
    target_ = dragsObjects_ ? layerUnder(at) : targetAt(at);
    viewport()->update();
}

void LayerList::startDrag()
{
    dragged_ = layers_->layerOf(pressed_->row);
    dragsObjects_ = dragged_ == 0 && pressed_->row.data(LayerModel::SelectedRole).toBool();
}

void LayerList::mouseReleaseEvent(QMouseEvent* event)
{
    const app::ContainerId layer = dragged_;
    const bool objects = dragsObjects_;
    const auto target = target_;
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (pressed && pressed->onSign)
        return releaseSign(*event, pressed->row);
    if (layer == 0 && !objects) {
        QListView::mouseReleaseEvent(event);
        if (pressed && pressed->showsMore)
            layers_->showMore(pressed->row);
        else if (pressed && pressed->picksAtRelease)
            pick(pressed->row, {});
        return;
    }
    endDrag();
    setState(NoState);
    const app::Containers& containers = session_.now().containers();
    if (objects && target && containers.contains(target->place.parent))
        app::moveSelectionTo(session_, target->place.parent);
    else if (target && layer != 0 && containers.contains(layer))
        app::moveLayer(session_, layer, target->place);
}

void LayerList::releaseSign(QMouseEvent& event, const QModelIndex& row)
{
    if (!row.isValid() || indexAt(event.position().toPoint()) != row)
        return;
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    option.rect = visualRect(row);
    itemDelegate()->editorEvent(&event, layers_, option, row);
}

void LayerList::mouseDoubleClickEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    const QModelIndex index = indexAt(at);
    if (index.isValid() && LayerPainter::hitsSign(visualRect(index), index, at))
        return mousePressEvent(event); // a second click on it
    PanelList::mouseDoubleClickEvent(event);
}

void LayerList::endDrag()
{
    dragged_ = 0;
    dragsObjects_ = false;
    pressed_.reset();
    target_.reset();
    viewport()->update();
}

/// Objects go to the top of a layer.
std::optional<LayerList::Target> LayerList::layerUnder(const QPoint& at) const
{
    const QModelIndex index = indexAt(at);
    const app::ContainerId layer = layers_->layerAround(index);
    if (layer == 0)
        return std::nullopt;
    const QModelIndex row = layers_->indexOf(layer);
    return Target{{layer, {}}, visualRect(row.isValid() ? row : index), true};
}

// The upper and the lower quarter of a row mean the place above and below it.
std::optional<LayerList::Target> LayerList::targetAt(const QPoint& at) const
{
    const app::Containers& tree = session_.now().containers();
    const QModelIndex index = indexAt(at);
    const auto line = [&](const QRect& row, int y) { return QRect(row.left(), y, row.width(), 0); };
    if (!index.isValid()) {
        const QRect last = visualRect(layers_->index(layers_->rowCount() - 1));
        return Target{{0, 0}, line(last, last.bottom())};
    }
    const app::ContainerId layer = layers_->layerAround(index);
    if (layers_->layerOf(index) == 0) // a group or an object: the layer around it
        return layerUnder(at);
    const QRect row = visualRect(index);
    if (at.y() < row.top() + row.height() / 4)
        return Target{{tree.parentOf(layer), layer}, line(row, row.top())};
    if (at.y() < row.bottom() - row.height() / 4)
        return Target{{layer, {}}, row, true};
    const auto below = app::placeBelow(tree, layer);
    return Target{below, line(row, row.bottom())};
}

void LayerList::paintEvent(QPaintEvent* event)
{
    QListView::paintEvent(event);
    if (!target_)
        return;
    QPainter painter(viewport());
    painter.setPen(QPen(lookOf(palette()).selection, 2));
    if (target_->inside)
        painter.drawRect(target_->mark.adjusted(1, 1, -2, -2));
    else
        painter.drawLine(target_->mark.left(), target_->mark.top(),
                         target_->mark.left() + target_->mark.width(), target_->mark.top());
}

} // namespace ui
