// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_wish.h"

#include <QImage>

#include <mutex>

namespace app {

/// The inputs of a picture of all lines, whatever the windows remove.
struct DrawingKey {
    FrameKey frame; ///< lines, view and pixels alone
    std::optional<Colour> page{};
    double leastWidth = 0, strokes = 0;
    friend bool operator==(const DrawingKey&, const DrawingKey&) = default;
};
DrawingKey drawingKeyOf(const FrameWish& wish);

/// The latest pictures of all lines, for any thread. The panes of a canvas share them: where all
/// show the same view, the lines are painted for one of them.
class DrawingPictures {
public:
    struct Found {
        QImage picture;
        std::vector<QRect> missing; ///< device pixels; to be painted, they do not overlap
    };
    /// What there is of a picture: all, or what a pan by whole pixels has left in the view, or
    /// nothing.
    Found find(const DrawingKey& key) const;
    void keep(const DrawingKey& key, const QImage& picture);

private:
    struct Kept {
        DrawingKey key;
        QImage picture;
    };
    mutable std::mutex lock_;
    std::vector<Kept> kept_; ///< the latest one last
};

} // namespace app
