// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/heading.h"

#include <QGridLayout>

namespace ui {

/// A titled part of the column at the right: a grid of labels and fields.
class Section : public QWidget {
    Q_OBJECT

public:
    explicit Section(const QString& title, QWidget* parent = nullptr);

    void setRemark(const QString& remark) { heading_->setRemark(remark); }

protected:
    QGridLayout& grid() { return *grid_; }
    /// Adds a row; returns the layout beside the label, which ends with a stretch.
    QHBoxLayout* addRow(const QString& label, const QList<QWidget*>& fields);
    void addWide(QWidget* widget); ///< a row without a label

private:
    Heading* heading_;
    QGridLayout* grid_;
};

} // namespace ui
