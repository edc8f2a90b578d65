// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"

#include <QWidget>

namespace ui {

/// Colours in rows, of which one is picked: by a click, or with the arrow keys and Enter or Space.
/// Its height is that of its number of rows, however many colours there are.
class Swatches : public QWidget {
    Q_OBJECT

public:
    Swatches(const QString& name, int columns, int rows, QWidget* parent = nullptr);

    void setRows(int rows);
    void setColours(std::vector<app::Colour> colours); ///< as many as fit
    /// Marks the colour that is in use; empty: none of them.
    void mark(const std::optional<app::Colour>& colour);
    bool has(const app::Colour& colour) const;
    const std::vector<app::Colour>& colours() const { return colours_; }
    QRect squareOf(std::size_t colour) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void picked(const app::Colour& colour);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    std::optional<std::size_t> colourAt(const QPointF& place) const;
    void goTo(std::size_t colour);
    void tell();

    QString name_;
    int columns_, rows_;
    std::vector<app::Colour> colours_;
    std::optional<std::size_t> marked_;
    std::size_t at_ = 0; ///< with the keyboard
};

} // namespace ui
