// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/table_view.h"

#include <QScrollArea>

class QGridLayout;

namespace ui {

/// Tables with titles and notes, two side by side if there is room.
class TablesPage : public QScrollArea {
    Q_OBJECT

public:
    explicit TablesPage(QWidget* parent = nullptr);

    struct Entry {
        app::Table table;
        TableView::Rows rows = TableView::Rows::Sortable;
    };
    void show(std::vector<Entry> entries);

    /// The table that last had the focus, by default the first; null: none.
    const app::Table* current() const { return last_ ? &last_->table() : nullptr; }
    /// The view of the table with this key, until the next show(); null: there is none.
    TableView* viewOf(QStringView key) const;
    void copy() const; ///< copies current() to the clipboard

    /// Puts a widget above the tables; show() keeps it.
    void setTop(QWidget* top);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Block {
        QWidget* whole;
        TableView* view;
    };
    Block blockOf(Entry entry);
    void place();

    QWidget* body_;
    QGridLayout* grid_;
    QWidget* top_ = nullptr;
    std::vector<Block> blocks_;
    TableView* last_ = nullptr; ///< the view that last had the focus
    bool paired_ = false;
};

} // namespace ui
