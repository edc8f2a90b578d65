// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/palette_rows.h"
#include "ui/widgets/checked_model.h"

#include <QStyledItemDelegate>

namespace ui {

QString partName(PaletteRow::Part part); ///< "Commands"

/// The rows that are found, below a heading for each part.
class PaletteModel : public CheckedModel {
    Q_OBJECT

public:
    enum Role {
        IsRowRole = Qt::UserRole,
        BeforeRole,
        WhatRole,
        NoteRole,
        EnabledRole,
        LettersRole
    };

    using CheckedModel::CheckedModel;

    void show(std::vector<PaletteRow> rows, const QString& typed);
    bool isRow(int line) const { return row(line) != nullptr; } ///< not a heading
    const PaletteRow* row(int line) const;                      ///< null: there is none
    int heightOf(int line) const;
    /// The first row that can be run, if it fits no worse than the very first; else that; -1: none.
    int bestLine() const;

protected:
    int rows() const override { return int(lines_.size()); }
    QVariant cell(int row, int column, int role) const override;

private:
    std::vector<PaletteRow> found_;
    struct Line {
        QString heading; ///< empty: a row
        std::size_t row = 0;
    };
    std::vector<Line> lines_;
};

/// Icon, name with the letters that were typed, what it is, keys or reason.
class PalettePainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace ui
