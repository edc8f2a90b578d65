// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/session.h"

#include <QAbstractListModel>
#include <QListView>
#include <QStyledItemDelegate>

namespace ui {

/// The catalogue of algorithms as a model: one row each.
class AlgorithmModel : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
};

/// Digit, marker, abbreviation, name, year. What is chosen there is chosen in the session.
class AlgorithmList : public QListView {
    Q_OBJECT

public:
    explicit AlgorithmList(app::Session& session, QWidget* parent = nullptr);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void follow();

    app::Session& session_;
};

/// Paints a chosen row's tint, with its bar at the left, or a hovered row's ground.
void drawRowGround(QPainter& painter, const QStyleOptionViewItem& option);

} // namespace ui
