// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_choice.h"
#include "ui/export/export_section.h"

#include <QButtonGroup>

namespace ui {

/// The formats as tiles, of which one is chosen: the name, and below it what it is for.
class FormatTiles : public ExportSection {
    Q_OBJECT

public:
    explicit FormatTiles(QWidget* parent = nullptr);

    void choose(const app::Format& format); ///< without a signal

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void picked(const app::Format& format); ///< by the person

private:
    void lay(int inRow); ///< so many tiles in a row

    std::vector<const app::Format*> formats_;
    QButtonGroup group_;
    QGridLayout* tiles_;
    int inRow_ = 0;
};

} // namespace ui
