// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui {

/// A dot for each page of a lesson; the current one is filled in the selection colour.
/// They stand closer where there is less room.
class PageDots : public QWidget {
    Q_OBJECT

public:
    explicit PageDots(QWidget* parent = nullptr);

    void show(std::size_t page, std::size_t pages);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QSize sizeWith(int distance) const;

    int page_ = 0, pages_ = 0;
};

} // namespace ui
