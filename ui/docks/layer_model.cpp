// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layer_model.h"

#include "app/commands/set_containers.h"
#include "app/session/layer_colour.h"
#include "app/session/layer_steps.h"
#include "ui/look/text.h"

#include <QColor>

#include <algorithm>

namespace ui {

namespace {

// Appends layers, topmost first, each before those nested in it.
void append(std::vector<app::ContainerId>& layers, const app::Containers& containers,
            app::ContainerId around)
{
    const auto children = containers.childrenOf(around);
    for (auto id = children.rbegin();
         id != children.rend() && layers.size() < app::Containers::mostLayers; ++id)
        if (containers[*id].kind == app::Container::Kind::Layer) {
            layers.push_back(*id);
            append(layers, containers, *id);
        }
}

std::vector<app::ContainerId> layersOf(const app::Document& document)
{
    std::vector<app::ContainerId> layers;
    append(layers, document.containers(), 0);
    return layers;
}

} // namespace

LayerModel::LayerModel(app::Session& session, QObject* parent)
    : CheckedModel(parent), session_(session), layers_(layersOf(session.now()))
{
    connect(&session.document, &app::EditedDocument::changed, this, &LayerModel::follow);
}

int LayerModel::rows() const { return int(layers_.size()); }

app::ContainerId LayerModel::layerOf(const QModelIndex& index) const
{
    return isCell(index) ? layers_[std::size_t(index.row())] : 0;
}

QModelIndex LayerModel::indexOf(app::ContainerId layer) const
{
    return index(int(std::ranges::find(layers_, layer) - layers_.begin()));
}

QVariant LayerModel::cell(int row, int, int role) const
{
    const app::ContainerId id = layers_[std::size_t(row)];
    if (!session_.now().containers().contains(id))
        return {}; // the layers have changed; follow() will be called
    const app::Container& layer = session_.now().containers()[id];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return layer.name;
    case VisibleRole:
        return layer.visible;
    case LockedRole:
        return layer.locked;
    case CountRole:
        return qulonglong(session_.now().containers().rangeOf(id).size());
    case DepthRole:
        return session_.now().containers().depthOf(id);
    case Qt::DecorationRole:
        if (auto colour = app::layerColour(session_.now(), id);
            colour || (colour = app::strokeColourOf(session_.now(), id)))
            return QColor(colour->red, colour->green, colour->blue);
        return {};
    case Qt::ToolTipRole:
        return Text::tr(
            "Double click: rename. Click the colour: choose that of new objects. Alt+click "
            "on the eye: show only this layer. Drag: move.");
    case Qt::AccessibleTextRole:
        return Text::tr("%1, %2, %3")
            .arg(layer.name, layer.visible ? Text::tr("shown") : Text::tr("hidden"),
                 layer.locked ? Text::tr("locked") : Text::tr("not locked"));
    default:
        return {};
    }
}

bool LayerModel::change(int row, const QVariant& value, int role)
{
    const app::Containers& containers = session_.now().containers();
    const app::ContainerId id = layers_[std::size_t(row)];
    if (!containers.contains(id))
        return false;
    const app::Container before = containers[id];
    app::Container layer = before;
    QString text;
    if (role == VisibleRole) {
        layer.visible = value.toBool();
        text = layer.visible ? Text::tr("Show layer") : Text::tr("Hide layer");
    } else if (role == LockedRole) {
        layer.locked = value.toBool();
        text = layer.locked ? Text::tr("Lock layer") : Text::tr("Unlock layer");
    } else if (role == Qt::EditRole && !value.toString().trimmed().isEmpty()) {
        layer.name = value.toString().trimmed();
        text = Text::tr("Rename layer");
    }
    if (layer == before)
        return false;
    session_.history.push(new app::SetContainers(session_.document, containers.with(layer), text));
    return true;
}

void LayerModel::showOnly(const QModelIndex& index)
{
    app::showOnlyLayer(session_, layerOf(index));
}

bool LayerModel::addLayer()
{
    return app::addLayer(session_, Text::tr("Layer %1").arg(layers_.size() + 1));
}

bool LayerModel::mayRemove(app::ContainerId layer) const
{
    const app::Containers& containers = session_.now().containers();
    return containers.contains(layer) && layer != 0
           && (containers.parentOf(layer) != 0 || containers.childrenOf(0).size() > 1);
}

void LayerModel::removeLayer(app::ContainerId layer)
{
    if (mayRemove(layer))
        session_.history.push(new app::RemoveLayer(session_.document, layer));
}

void LayerModel::follow(const app::DocumentChange& change)
{
    auto layers = change.containers ? layersOf(session_.now()) : layers_;
    if (change.everything || layers != layers_) {
        beginResetModel();
        layers_ = std::move(layers);
        endResetModel();
    } else if (change.containers) {
        // No reset, because it would close an editor that is open on a name.
        tellChanged();
    } else if (change.objects) {
        tellChanged({CountRole, Qt::DecorationRole});
    }
}

} // namespace ui

#include "moc_layer_model.cpp"
