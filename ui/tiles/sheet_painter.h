// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_sheets.h"
#include "app/tiles/sheet_layout.h"
#include "app/view/view.h"
#include "ui/tiles/sheet_art.h"

class QPainter;

namespace ui {

/// Paints what is around the drawing on sheets: paper, overlaps, edges, marks and name tags.
class SheetPainter {
public:
    SheetPainter(QPainter& painter, const app::LiveSheets& sheets, const app::SheetLayout& layout,
                 const app::View& view, const Look& look);

    void paintPapers(bool tinted); ///< below the pictures
    void paintPictures(const std::vector<SheetArt::Picture>& pictures);
    void paintEdges();
    void paintMarks();
    void paintTags(const QFont& font, bool large);

private:
    QRectF onScreen(const clipping::Window& window) const;
    void paintOverlaps(const app::Tile& tile, const clipping::Window& part);
    void paintMarksOf(std::size_t sheet, const QRectF& paper);
    void paintTag(std::size_t sheet, const QFont& font, bool large);

    QPainter& painter_;
    const app::LiveSheets& sheets_;
    const app::SheetLayout& layout_;
    const app::View& view_;
    const Look& look_; ///< of what lies on paper
    const app::Tiling& tiling_;
};

} // namespace ui
