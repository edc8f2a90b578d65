// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/panes.h"
#include "app/view/drawing_pictures.h"
#include "ui/canvas/text_boxes.h"
#include "ui/tools/workbench.h"

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace ui {

/// The content of one of the surfaces that share a controller.
struct Pane {
    app::Variant choice;
    bool active = true;                        ///< shows the clip window's handles and label
    int among = 1;                             ///< number of panes painted in one frame
    app::LiveDifferences* fromExact = nullptr; ///< differences from exact to mark; null: none
    std::uint64_t revision = 0;                ///< of the differences found in fromExact
    /// The windows at which its variant cannot clip (app/scene/left_alone.h), and what it clips at
    /// instead of all windows; empty: at all.
    std::vector<std::size_t> leftAlone{};
    std::optional<app::ClipRegion> region{};
};

/// What the panes show in a frame. Their pictures stay valid until renew().
class Frames : public QObject {
    Q_OBJECT

public:
    explicit Frames(const Workbench& bench) : bench_(bench), textBoxes_(bench.session.scene) {}

    void renew() { ++revision_; } ///< the display, the selection or the look has changed
    void followPage();            ///< it sets the size of a millimetre
    /// The frame that a pane shows now; `pixels` is the size of its image.
    app::FrameWish wish(const Pane& pane, double pixelRatio, const QSize& pixels) const;
    /// How long this turn of the event loop may still wait for pictures, which are painted on other
    /// threads. All panes share it.
    std::chrono::microseconds patience();
    double ghostOpacity() const; ///< of the removed lines' layer, 0 to 1
    /// The lines whose results differ between the pane's variant and `exact`; null: not known yet,
    /// or not asked for.
    std::shared_ptr<const app::Differences> differing(const Pane& pane) const;
    /// Boxes that labels should not cover, in logical pixels.
    const std::vector<QRectF>& textBoxes() const { return textBoxes_.in(bench_.view); }

private:
    const app::Session& session() const { return bench_.session; }
    app::PictureOptions pictureOptions(double pixelRatio) const;
    void addDifferences(app::FrameWish& wish, const Pane& pane) const;
    void addErrors(app::FrameWish& wish) const;

    const Workbench& bench_;
    mutable TextBoxes textBoxes_; ///< computed on demand
    std::shared_ptr<app::DrawingPictures> drawings_ = std::make_shared<app::DrawingPictures>();
    std::uint64_t revision_ = 1;
    struct Images { ///< of a document
        app::Document of;
        std::vector<app::SeenUnderlay> seen{};
        app::ImageCount count{};
        std::uint64_t revision = 0;
    };
    const Images& images() const;
    mutable Images images_;                                         ///< computed on demand
    double unitSize_ = 0;                                           ///< millimetres per user unit
    std::optional<std::chrono::steady_clock::time_point> turnEnds_; ///< for waiting
};

} // namespace ui
