// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layer_list.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>

#include <algorithm>

namespace ui {

LayerList::LayerList(app::Session& session, LayerModel* model)
    : session_(session), layers_(model), commands_(makeCommands())
{
    setModel(model);
    setAccessibleName(Text::tr("Layers"));
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setEditTriggers(DoubleClicked);
    viewport()->setAutoFillBackground(false);
    for (const auto changed : {&QAbstractItemModel::rowsRemoved, &QAbstractItemModel::rowsInserted})
        connect(model, changed, this, &LayerList::endDrag); // for example by undo
    connect(model, &QAbstractItemModel::modelReset, this, &LayerList::endDrag);
}

app::ContainerId LayerList::current() const
{
    return currentIndex().isValid() ? layers_->layerOf(currentIndex()) : 0;
}

const LayerCommand* LayerList::commandOf(const QKeyEvent& event) const
{
    const QKeySequence pressed(
        QKeyCombination(event.modifiers() & ~Qt::KeypadModifier, Qt::Key(event.key())));
    const auto found = std::ranges::find(commands_, pressed, &LayerCommand::key);
    return found == commands_.end() || current() == 0 ? nullptr : &*found;
}

// While the list has the focus, its keys go before the shortcuts of the window, such as F2.
bool LayerList::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && commandOf(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QListView::event(event);
}

void LayerList::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && dragged_ != 0)
        return endDrag();
    const LayerCommand* command = commandOf(*event);
    if (!command)
        return PanelList::keyPressEvent(event);
    if (!command->enabled || command->enabled(current()))
        command->run(current());
}

void LayerList::mousePressEvent(QMouseEvent* event)
{
    const bool onRow = indexAt(event->position().toPoint()).isValid();
    pressed_ = event->button() == Qt::LeftButton && onRow
                   ? std::optional(event->position().toPoint())
                   : std::nullopt;
    QListView::mousePressEvent(event);
}

void LayerList::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    if (pressed_ && dragged_ == 0
        && (at - *pressed_).manhattanLength() >= QApplication::startDragDistance())
        dragged_ = layers_->layerOf(indexAt(*pressed_));
    if (dragged_ == 0)
        return QListView::mouseMoveEvent(event);
    target_ = targetAt(at);
    viewport()->update();
}

void LayerList::mouseReleaseEvent(QMouseEvent* event)
{
    const app::ContainerId layer = dragged_;
    const auto target = target_;
    const bool exists = session_.now().containers().contains(layer);
    pressed_.reset();
    if (layer == 0)
        return QListView::mouseReleaseEvent(event);
    endDrag();
    setState(NoState);
    if (target && exists)
        app::moveLayer(session_, layer, target->place);
}

void LayerList::endDrag()
{
    dragged_ = 0;
    pressed_.reset();
    target_.reset();
    viewport()->update();
}

// The upper and the lower quarter of a row mean the place above and below it.
LayerList::Target LayerList::targetAt(const QPoint& at) const
{
    const app::Containers& tree = session_.now().containers();
    const QModelIndex index = indexAt(at);
    const auto line = [&](const QRect& row, int y) { return QRect(row.left(), y, row.width(), 0); };
    if (!index.isValid()) {
        const QRect last = visualRect(layers_->index(layers_->rowCount() - 1));
        return {{0, 0}, line(last, last.bottom())};
    }
    const QRect row = visualRect(index);
    const app::ContainerId layer = layers_->layerOf(index);
    if (at.y() < row.top() + row.height() / 4)
        return {{tree.parentOf(layer), layer}, line(row, row.top())};
    if (at.y() < row.bottom() - row.height() / 4)
        return {{layer, {}}, row, true};
    const auto below = app::placeBelow(tree, layer);
    return {below, line(row, row.bottom())};
}

void LayerList::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = byKey ? currentIndex() : indexAt(event->pos());
    if (!index.isValid())
        return;
    setCurrentIndex(index);
    const app::ContainerId layer = layers_->layerOf(index);
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const LayerCommand& command : commands_) {
        if (command.text.isEmpty()) {
            menu->addSeparator();
        } else if (!command.enabled || command.enabled(layer)) {
            const QString key = command.key.toString(QKeySequence::NativeText);
            menu->addAction(key.isEmpty() ? command.text : command.text + '\t' + key,
                            [run = command.run, layer, this] {
                                if (session_.now().containers().contains(layer))
                                    run(layer);
                            });
        }
    }
    menu->popup(byKey ? viewport()->mapToGlobal(visualRect(index).bottomLeft())
                      : event->globalPos());
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

#include "moc_layer_list.cpp"
