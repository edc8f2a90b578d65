// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layer_list.h"

#include "ui/look/text.h"

#include <QContextMenuEvent>
#include <QMenu>

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
    setUniformItemSizes(true);
    setAutoScroll(false); // a click on a row that is half seen would move it from the pointer
    viewport()->setAutoFillBackground(false);
    for (const auto changed : {&QAbstractItemModel::rowsRemoved, &QAbstractItemModel::rowsInserted})
        connect(model, changed, this, &LayerList::endDrag); // for example by undo
    connect(model, &QAbstractItemModel::modelReset, this, &LayerList::endDrag);
}

app::ContainerId LayerList::current() const { return layers_->layerOf(currentIndex()); }

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
    const bool isKey = event->type() == QEvent::ShortcutOverride;
    if (isKey
        && (commandOf(*static_cast<QKeyEvent*>(event))
            || renames(*static_cast<QKeyEvent*>(event)))) {
        event->accept();
        return true;
    }
    return QListView::event(event);
}

void LayerList::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape
        && (dragged_ != 0 || dragsObjects_ || (pressed_ && pressed_->onSign)))
        return endDrag();
    if (const LayerCommand* command = commandOf(*event)) {
        if (!command->enabled || command->enabled(current()))
            command->run(current());
        return;
    }
    if (renames(*event))
        return edit(currentIndex());
    if (treeKey(*event))
        return event->accept();
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier)
        return pick(currentIndex(), Qt::ControlModifier);
    const QModelIndex before = currentIndex();
    PanelList::keyPressEvent(event);
    scrollTo(currentIndex());
    const bool onlyMoves = event->modifiers() & Qt::ControlModifier; // Ctrl+Space takes it
    if (currentIndex() != before && current() == 0 && !onlyMoves)
        pick(currentIndex(), event->modifiers());
}

/// The name of a group or an object; that of a layer is one of its commands.
bool LayerList::renames(const QKeyEvent& event) const
{
    const app::TreeRow* row = layers_->rowAt(currentIndex());
    using Kind = app::TreeRow::Kind;
    return row && (row->kind == Kind::Group || row->kind == Kind::Object)
           && event.key() == Qt::Key_F2 && event.modifiers() == Qt::NoModifier;
}

/// Right opens, Left closes or goes to what is around it; Enter shows more.
bool LayerList::treeKey(const QKeyEvent& event)
{
    const QModelIndex index = currentIndex();
    const app::TreeRow* row = layers_->rowAt(index);
    if (!row || (event.modifiers() & ~Qt::KeypadModifier))
        return false;
    const bool opens = index.data(LayerModel::OpenRole).isValid();
    if (event.key() == Qt::Key_Right && opens) {
        layers_->setOpen(index, true);
    } else if (event.key() == Qt::Key_Left && layers_->isOpen(index)) {
        layers_->setOpen(index, false);
    } else if (event.key() == Qt::Key_Left) {
        const bool isContainer = index.data(LayerModel::CountRole).isValid();
        const app::ContainerId around =
            isContainer ? session_.now().containers().parentOf(row->container) : row->container;
        if (around != 0)
            setCurrentIndex(layers_->indexOf(around));
    } else if (row->kind == app::TreeRow::Kind::More
               && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)) {
        layers_->showMore(index);
    } else {
        return false;
    }
    return true;
}

/// Only layers and groups have a name that can be edited.
bool LayerList::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event)
{
    const bool opensEditor = trigger == DoubleClicked || trigger == AllEditTriggers;
    const app::TreeRow* row = layers_->rowAt(index);
    return (!opensEditor || (row && row->kind != app::TreeRow::Kind::More))
           && PanelList::edit(index, trigger, event);
}

void LayerList::select(const app::ObjectRanges& objects)
{
    layers_->keepOpen();
    selects_ = true;
    session_.entered.enter(0);
    session_.select(objects);
    selects_ = false;
}

void LayerList::pick(const QModelIndex& index, Qt::KeyboardModifiers modifiers)
{
    const app::TreeRow* row = layers_->rowAt(index);
    if (!row || row->kind == app::TreeRow::Kind::More)
        return;
    const bool extends = modifiers & Qt::ShiftModifier && anchor_.isValid();
    const int from = extends ? anchor_.row() : index.row();
    app::ObjectRanges objects =
        layers_->objectsOf(std::min(from, index.row()), std::max(from, index.row()));
    if (!extends)
        anchor_ = index;
    if (objects.empty())
        return emit session_.refused(Text::tr("%1 is locked or hidden. Unlock and show it first.")
                                         .arg(index.data().toString()));
    if (!extends && modifiers & Qt::ControlModifier) {
        const bool all = common(objects, session_.selection()).size() == objects.size();
        objects =
            all ? without(session_.selection(), objects) : united(session_.selection(), objects);
    }
    select(objects);
}

void LayerList::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = byKey ? currentIndex() : indexAt(event->pos());
    if (!index.isValid())
        return;
    const QPoint place =
        byKey ? viewport()->mapToGlobal(visualRect(index).bottomLeft()) : event->globalPos();
    setCurrentIndex(index);
    if (layers_->layerOf(index) != 0)
        return layerMenu(index, place);
    if (!index.data(LayerModel::SelectedRole).toBool())
        pick(index, {});
    if (index.data(LayerModel::SelectedRole).toBool())
        emit objectMenuWanted(place);
}

void LayerList::layerMenu(const QModelIndex& index, const QPoint& place)
{
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
    menu->popup(place);
}

} // namespace ui

#include "moc_layer_list.cpp"
