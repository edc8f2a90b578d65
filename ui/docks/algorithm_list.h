// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QAbstractListModel>
#include <QListView>
#include <QStyledItemDelegate>
#include <QToolButton>

namespace ui {

/// The catalogue of algorithms as a model: one row each.
class AlgorithmModel : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
};

/// Digit, marker, abbreviation, name, year. What is chosen there is chosen in the session. The row
/// under the pointer has a "?" in place of the year, and every row a menu: its page.
class AlgorithmList : public QListView {
    Q_OBJECT

public:
    explicit AlgorithmList(app::Session& session, QWidget* parent = nullptr);

signals:
    void aboutWanted(const clipping::Algorithm& algorithm); ///< its page is to be shown

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    bool viewportEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void follow();
    void offerAbout(const QModelIndex& index);

    app::Session& session_;
    QToolButton* about_; ///< "?" on the row under the pointer
    QPersistentModelIndex offered_;
};

/// Paints a chosen row's tint, with its bar at the left, or a hovered row's ground.
void drawRowGround(QPainter& painter, const QStyleOptionViewItem& option);

} // namespace ui
