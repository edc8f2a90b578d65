// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The layers of the drawing, topmost first; a nested layer follows its parent. Every change is an
/// undoable step.
class LayerModel : public CheckedModel {
    Q_OBJECT

public:
    enum Role { VisibleRole = Qt::UserRole, LockedRole, CountRole, DepthRole };
    // Qt::DecorationRole: the layer's colour, else that of its first object

    explicit LayerModel(app::Session& session, QObject* parent = nullptr);

    app::ContainerId layerOf(const QModelIndex& index) const; ///< 0: of no row
    QModelIndex indexOf(app::ContainerId layer) const;

    void showOnly(const QModelIndex& index); ///< hides the others, or shows all again
    bool addLayer(); ///< above all others; false: the drawing has too many layers
    bool mayRemove(app::ContainerId layer) const; ///< false for the last layer
    void removeLayer(app::ContainerId layer);     ///< with the layers nested in it

protected:
    int rows() const override;
    QVariant cell(int row, int column, int role) const override;
    bool change(int row, const QVariant& value, int role) override;
    Qt::ItemFlags moreFlags() const override { return Qt::ItemIsEditable; }

private:
    void follow(const app::DocumentChange& change);

    app::Session& session_;
    std::vector<app::ContainerId> layers_; ///< as last reported to views, topmost first
};

} // namespace ui
