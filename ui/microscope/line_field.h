// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QLineEdit>

namespace ui {

/// A line as editable text: "−160, −30 → 70, 130". Esc restores the previous text.
class LineField : public QLineEdit {
    Q_OBJECT

public:
    explicit LineField(QWidget* parent = nullptr);

    void show(const clipping::Segment& line);

signals:
    void typed(const clipping::Segment& line);
    void done(); ///< typing is finished: the microscope's step keys work again
    void refused(const QString& sentence);

protected:
    bool event(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void read();

    clipping::Segment line_{};
};

} // namespace ui
