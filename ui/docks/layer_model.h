// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QAbstractListModel>

namespace ui {

/// The layers of the drawing, the topmost first; those in another one follow it. Every change is an
/// undoable step.
class LayerModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { VisibleRole = Qt::UserRole, LockedRole, CountRole, DepthRole };

    explicit LayerModel(app::Session& session, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    app::ContainerId layerOf(const QModelIndex& index) const;
    QModelIndex indexOf(app::ContainerId layer) const;

    bool addLayer(); ///< above all others; whether there was room for it
    bool mayRemove(app::ContainerId layer) const; ///< one layer stays
    void removeLayer(app::ContainerId layer);     ///< with those that lie in it

private:
    void follow(const app::DocumentChange& change);

    app::Session& session_;
    std::vector<app::ContainerId> layers_; ///< as views know them, the topmost first
};

} // namespace ui
