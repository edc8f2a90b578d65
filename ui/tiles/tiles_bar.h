// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tiles/sheet_layout.h"

#include <QWidget>

namespace ui {

class Segments;

/// The bar over the sheets: how they are shown.
class TilesBar : public QWidget {
    Q_OBJECT

public:
    explicit TilesBar(QWidget* parent = nullptr);

    void show(app::SheetArrangement arrangement, bool tinted);

signals:
    void arranged(app::SheetArrangement arrangement);
    void tinted(bool tinted);
    void fitWanted();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Segments *show_, *overlap_;
};

} // namespace ui
