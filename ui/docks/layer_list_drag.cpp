// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/rearrange_selection.h"
#include "ui/docks/layer_list.h"
#include "ui/docks/layer_painter.h"
#include "ui/look/look.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
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
        pressed_->mark = LayerPainter::markAt(visualRect(index), index, at);
        pressed_->last = index.row();
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
        return sweep(at);
    if (pressed_ && dragged_ == 0 && !dragsObjects_
        && (at - pressed_->at).manhattanLength() >= QApplication::startDragDistance())
        startDrag();
    if (dragged_ == 0 && !dragsObjects_)
        return QListView::mouseMoveEvent(event);
    target_ = dragsObjects_ ? targetOfObjects(at) : targetAt(at);
    viewport()->update();
}

/// From an eye or padlock over those of other rows: all become as the first one does.
void LayerList::sweep(const QPoint& at)
{
    const QModelIndex index = indexAt(at);
    if (!pressed_->mark || !index.isValid() || index.row() == pressed_->last)
        return;
    pressed_->last = index.row();
    viewport()->update();
}

std::optional<bool> LayerList::sweptAs(const QModelIndex& index, int role) const
{
    if (!pressed_ || pressed_->mark != role || !pressed_->row.isValid()
        || pressed_->last == pressed_->row.row())
        return std::nullopt;
    const auto [first, last] = std::minmax({pressed_->row.row(), pressed_->last});
    if (index.row() < first || index.row() > last)
        return std::nullopt;
    return !pressed_->row.data(role).toBool();
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
        return releaseSign(*event, *pressed);
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
    if (objects && target && containers.contains(target->into))
        app::moveSelectionBetween(session_, target->into, target->at);
    else if (target && layer != 0 && containers.contains(layer))
        app::moveLayer(session_, layer, target->place);
}

void LayerList::releaseSign(QMouseEvent& event, const Press& pressed)
{
    const QModelIndex row = pressed.row;
    if (!row.isValid())
        return;
    if (pressed.mark && pressed.last != row.row()) {
        const auto [first, last] = std::minmax({row.row(), pressed.last});
        return layers_->changeTogether(first, last, *pressed.mark,
                                       !row.data(*pressed.mark).toBool());
    }
    if (indexAt(event.position().toPoint()) != row)
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

LayerList::Target LayerList::inside(app::ContainerId layerOrGroup, std::size_t end,
                                    const QRect& row)
{
    return {.into = layerOrGroup, .at = end, .mark = row, .inside = true};
}

/// Directly below a row. Below the last one in a group the place may also be outside it: the
/// further left the pointer is, the further out.
LayerList::Target LayerList::below(const QModelIndex& index, int x) const
{
    const app::Containers& tree = session_.now().containers();
    const app::TreeRow& row = *layers_->rowAt(index);
    const QRect box = visualRect(index);
    const auto isGroup = [&](app::ContainerId id) {
        return tree[id].kind == app::Container::Kind::Group;
    };
    const bool isObject = row.kind == app::TreeRow::Kind::Object;
    app::ContainerId into = isObject ? row.container : tree.parentOf(row.container);
    std::size_t at = isObject ? row.number : tree.rangeOf(row.container).first;
    int depth = row.depth;
    const app::TreeRow* next = layers_->rowAt(index.siblingAtRow(index.row() + 1));
    for (const int last = next ? next->depth : 1;
         depth > last && isGroup(into) && x < LayerPainter::leftOf(box, depth); --depth) {
        at = tree.rangeOf(into).first;
        into = tree.parentOf(into);
    }
    const int left = LayerPainter::leftOf(box, depth);
    return {.into = into, .at = at, .mark = {left, box.bottom(), box.right() - left, 0}};
}

/// Objects go above or below others, into a group, or to the top of a layer.
std::optional<LayerList::Target> LayerList::targetOfObjects(const QPoint& at) const
{
    using Kind = app::TreeRow::Kind;
    const app::Containers& tree = session_.now().containers();
    const QModelIndex index = indexAt(at);
    const app::TreeRow* row = layers_->rowAt(index);
    if (!row || !tree.contains(row->container))
        return std::nullopt;
    const QRect box = visualRect(index);
    const app::ObjectRange all = tree.rangeOf(row->container);
    if (row->kind == Kind::Layer || row->kind == Kind::More)
        return inside(row->container, all.end, box);
    if (row->kind == Kind::Group && session_.selection().contains(all))
        return std::nullopt; // it is dragged itself
    const bool isObject = row->kind == Kind::Object;
    const int zone = isObject ? box.height() / 2 : box.height() / 4;
    const int left = LayerPainter::leftOf(box, row->depth);
    if (at.y() < box.top() + zone)
        return Target{.into = isObject ? row->container : tree.parentOf(row->container),
                      .at = isObject ? row->number + 1 : all.end,
                      .mark = {left, box.top(), box.right() - left, 0}};
    if (!isObject && (at.y() < box.bottom() - zone || layers_->isOpen(index)))
        return inside(row->container, all.end, box);
    return below(index, at.x());
}

// The upper and the lower quarter of a layer mean the place above and below it.
std::optional<LayerList::Target> LayerList::targetAt(const QPoint& at) const
{
    const app::Containers& tree = session_.now().containers();
    const QModelIndex index = indexAt(at);
    const auto line = [&](const app::ContainerPlace& place, const QRect& row, int y) {
        const int depth = place.parent == 0 ? 1 : tree.depthOf(place.parent) + 1;
        const int left = LayerPainter::leftOf(row, depth);
        return Target{.place = place, .mark = {left, y, row.right() - left, 0}};
    };
    if (!index.isValid()) {
        const QRect last = visualRect(layers_->index(layers_->rowCount() - 1));
        return line({0, 0}, last, last.bottom());
    }
    const app::ContainerId layer = layers_->layerAround(index);
    const QModelIndex own = layers_->indexOf(layer);
    const QRect row = visualRect(own.isValid() ? own : index);
    if (layer != 0 && layers_->layerOf(index) != 0 && at.y() < row.top() + row.height() / 4)
        return line({tree.parentOf(layer), layer}, row, row.top());
    if (layers_->layerOf(index) != 0 && at.y() >= row.bottom() - row.height() / 4)
        return line(app::placeBelow(tree, layer), row, row.bottom());
    return Target{.place = {layer, {}}, .mark = row, .inside = true};
}

void LayerList::paintEvent(QPaintEvent* event)
{
    constexpr int ring = 4; // its radius, at the level where the line begins
    QListView::paintEvent(event);
    if (!target_)
        return;
    QPainter painter(viewport());
    painter.setPen(QPen(lookOf(palette()).selection, 2));
    const QRect& mark = target_->mark;
    if (target_->inside)
        return painter.drawRect(mark.adjusted(1, 1, -2, -2));
    painter.drawLine(mark.left() + ring, mark.top(), mark.left() + mark.width(), mark.top());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawEllipse(mark.topLeft(), ring, ring);
}

} // namespace ui
