// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/widgets/checked_model.h"

#include <QListView>
#include <QStyledItemDelegate>
#include <QToolButton>

namespace ui {

/// The catalogue of algorithms as a model: one row per algorithm. A row's tooltip says whether
/// it can clip at the window in hand.
class AlgorithmModel : public CheckedModel {
    Q_OBJECT

public:
    AlgorithmModel(const app::Session& session, QObject* parent)
        : CheckedModel(parent), session_(session)
    {
    }

protected:
    int rows() const override;
    QVariant cell(int row, int column, int role) const override;

private:
    QString limitOf(const clipping::Algorithm& row) const;

    const app::Session& session_;
};

/// The list of algorithms: shortcut digit, marker, abbreviation, name, year; or, dimmed, the reason
/// why the row cannot clip at the window in hand. Selecting a row selects its algorithm in the
/// session, also a dimmed one. The hovered row shows a "?" in place of the year, which
/// opens the algorithm's page; so does each row's context menu.
class AlgorithmList : public QListView {
    Q_OBJECT

public:
    explicit AlgorithmList(app::Session& session, QWidget* parent = nullptr);

signals:
    void aboutWanted(const clipping::Algorithm& algorithm); ///< asks for its page
    /// The right button or the key for menus was pressed; `place` is on the screen.
    void menuWanted(const clipping::Algorithm& algorithm, const QPoint& place);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    bool viewportEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void follow();
    void offerAbout(const QModelIndex& index);

    app::Session& session_;
    QToolButton* about_; ///< "?" on the hovered row
    QPersistentModelIndex offered_;
};

/// Paints the background of a row: a selected row's tint, with a bar at the left, or a hovered
/// row's colour.
void drawRowGround(QPainter& painter, const QStyleOptionViewItem& option);

} // namespace ui
