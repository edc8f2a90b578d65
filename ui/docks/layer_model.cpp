// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layer_model.h"

#include "app/commands/set_layers.h"
#include "app/document/layer_report.h"

#include <QColor>

namespace ui {

LayerModel::LayerModel(app::Session& session, QObject* parent)
    : QAbstractListModel(parent), session_(session), rows_(int(session.sheet().layers.size()))
{
    connect(&session.drawing, &app::Drawing::changed, this, &LayerModel::follow);
}

int LayerModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

std::uint32_t LayerModel::layerOf(const QModelIndex& index) const
{
    return std::uint32_t(rowCount() - 1 - index.row());
}

QModelIndex LayerModel::indexOf(std::uint32_t layer) const
{
    return index(rowCount() - 1 - int(layer));
}

QVariant LayerModel::data(const QModelIndex& index, int role) const
{
    const std::uint32_t number = layerOf(index);
    const app::Layer& layer = session_.sheet().layers[number];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return layer.name;
    case VisibleRole:
        return layer.visible;
    case LockedRole:
        return layer.locked;
    case CountRole:
        return qulonglong(app::linesOfLayer(session_, number));
    case Qt::DecorationRole:
        if (const auto ink = app::inkOfLayer(session_.sheet(), number))
            return QColor(ink->red, ink->green, ink->blue);
        return {};
    case Qt::AccessibleTextRole:
        return tr("%1, %2, %3")
            .arg(layer.name, layer.visible ? tr("shown") : tr("hidden"),
                 layer.locked ? tr("locked") : tr("not locked"));
    default:
        return {};
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    auto layers = session_.sheet().layers;
    app::Layer& layer = layers[layerOf(index)];
    const app::Layer before = layer;
    QString text;
    if (role == VisibleRole) {
        layer.visible = value.toBool();
        text = layer.visible ? tr("Show layer") : tr("Hide layer");
    } else if (role == LockedRole) {
        layer.locked = value.toBool();
        text = layer.locked ? tr("Lock layer") : tr("Unlock layer");
    } else if (role == Qt::EditRole && !value.toString().trimmed().isEmpty()) {
        layer.name = value.toString().trimmed();
        text = tr("Rename layer");
    }
    if (layer == before)
        return false;
    session_.history.push(new app::SetLayers(session_.drawing, std::move(layers), text));
    return true;
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const
{
    return QAbstractListModel::flags(index) | Qt::ItemIsEditable;
}

void LayerModel::addLayer()
{
    auto layers = session_.sheet().layers;
    layers.push_back({tr("Layer %1").arg(layers.size() + 1)});
    session_.history.push(new app::SetLayers(session_.drawing, std::move(layers), tr("Add layer")));
}

void LayerModel::removeLayer(std::uint32_t layer)
{
    if (session_.sheet().layers.size() > 1)
        session_.history.push(new app::RemoveLayer(session_.drawing, layer));
}

void LayerModel::follow(const app::Change& change)
{
    using Kind = app::Change::Kind;
    const int rows = int(session_.sheet().layers.size());
    if (change.kind == Kind::Everything || (change.kind == Kind::Layers && rows != rows_)) {
        beginResetModel();
        rows_ = rows;
        endResetModel();
    } else if (change.kind == Kind::Layers) {
        // No reset: the name is perhaps being edited in the list, which a reset would take away.
        emit dataChanged(index(0), index(rowCount() - 1));
    } else if (change.kind == Kind::Shapes) {
        emit dataChanged(index(0), index(rowCount() - 1), {CountRole, Qt::DecorationRole});
    }
}

} // namespace ui
