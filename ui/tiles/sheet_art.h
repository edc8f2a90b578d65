// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/session/live_sheets.h"
#include "app/tiles/sheet_layout.h"
#include "app/view/frame_painting.h"
#include "app/view/frame_times.h"
#include "ui/look/look.h"

#include <QImage>

#include <deque>

namespace ui {

/// A picture of the drawing that is wanted: of all lines in a region.
struct SheetWish {
    std::size_t sheet = 0;
    app::View view;           ///< of the drawing; its size is that of the picture
    app::ClipRegion region{}; ///< at which the drawing is cut
    app::RemovedPart removed = app::RemovedPart::Hidden;
};

/// Pictures of a drawing on its sheets. All lines are clipped at every sheet, like at clip windows.
/// They are painted one after the other, on other threads; until then the last pictures are there.
class SheetArt : public QObject {
    Q_OBJECT

public:
    SheetArt(app::Session& session, app::LiveSheets& sheets);

    /// Makes these pictures, unless they are there, and waits for some milliseconds. `revision`
    /// says whether the drawing or its colours are the same as before.
    void want(std::vector<SheetWish> wishes, std::uint64_t revision, const Look& look,
              double pixelRatio);

    struct Picture {
        std::size_t sheet;
        clipping::Window drawn; ///< what it shows, in user units
        QImage image;
    };
    /// The newest pictures; some may be out of date.
    const std::vector<Picture>& pictures() const { return pictures_; }
    void settle(); ///< until all are new
    void forget();

signals:
    void painted();                                ///< one more picture is new
    void frameShown(const app::FrameTimes& times); ///< all of them are

private:
    void paintNext();
    void accept(const app::ClipResult& clipped, app::PaintedFrame frame);
    app::FrameWish frameOf(const SheetWish& wish) const;

    app::Session& session_;
    app::LiveSheets& sheets_;
    std::vector<SheetWish> wanted_;
    std::deque<SheetWish> left_; ///< of those, the ones that are not yet painted
    SheetWish painted_;          ///< the one that is being painted, or the last one
    std::uint64_t revision_ = 0;
    const Look* look_ = nullptr;
    double pixelRatio_ = 1;
    mutable app::ImageCount images_; ///< of what is painted
    std::vector<Picture> pictures_;
    app::FrameTimes times_{};
    std::shared_ptr<app::FramePainter> painter_ = std::make_shared<app::FramePainter>();
    app::Background<app::PaintedFrame> painting_;
};

} // namespace ui
