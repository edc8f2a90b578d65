// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

namespace ui {

/// A titled part of a sheet about output: a grid of labels and fields, with a line below it.
class ExportSection : public QWidget {
public:
    explicit ExportSection(const QString& title, QWidget* parent = nullptr);

    void setTitle(const QString& title) { title_->setText(title); }

protected:
    QGridLayout& grid() { return *grid_; }
    /// Adds a label and the widgets beside it. The row can be hidden as a whole.
    struct Row {
        QLabel* name = nullptr;
        QWidget* beside = nullptr;
        void setVisible(bool visible) const;
    };
    Row addRow(const QString& name, const QList<QWidget*>& widgets);

private:
    QLabel* title_;
    QGridLayout* grid_;
};

} // namespace ui
