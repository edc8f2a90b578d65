// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/layer_model.h"
#include "ui/widgets/panel_list.h"

#include <optional>

namespace ui {

class LayerList;

/// A row of the list of layers: eye, what opens it, colour or kind, name, number of objects, and a
/// padlock, or a pencil at the layer of new objects. The signs of a deeper row begin further right,
/// except the eye.
class LayerPainter : public RowPainter {
public:
    explicit LayerPainter(LayerList& list);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

    static int leftOf(const QRect& row, int depth); ///< where the signs of that level begin
    /// Whether a press there is for a sign, not for the row.
    static bool hitsSign(const QRect& row, const QModelIndex& index, const QPoint& at);
    /// VisibleRole on an eye, LockedRole on a padlock.
    static std::optional<int> markAt(const QRect& row, const QModelIndex& index, const QPoint& at);

private:
    LayerList& list_;
};

} // namespace ui
