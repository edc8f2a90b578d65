// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QAbstractListModel>

namespace ui {

/// The clip windows of the drawing in the order in which they apply. Every change is an undoable
/// step.
class WindowModel : public QAbstractListModel {
    Q_OBJECT

public:
    /// IconRole: the key of the shape's icon. ColourRole: a QColor, not valid for the usual one.
    enum Role { VisibleRole = Qt::UserRole, OperationRole, IconRole, ColourRole };

    explicit WindowModel(app::Session& session, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    void follow();

    app::Session& session_;
    app::ClipWindows shown_; ///< as last reported to views
};

} // namespace ui
