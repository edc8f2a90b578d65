// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/document/document.h"
#include "app/document/object_ranges.h"
#include "app/scene/scene_lines.h"
#include "app/view/raster.h"

#include <QPoint>
#include <QSize>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// Frames with equal keys have the same picture.
struct FrameKey {
    std::uint64_t lines = 0;  ///< SceneLines::revision()
    std::uint64_t images = 0; ///< counts changes of FrameWish::underlays
    std::uint64_t look = 0;   ///< counts changes of everything that is not a member here
    View view{};
    ClipRegion region{};
    Variant variant{};     ///< that clips; not a known misprint
    QSize pixels{};        ///< of the image; empty: none is wanted
    double pixelRatio = 1; ///< device pixels per logical pixel
    std::vector<BorderLine> borders{};
    friend bool operator==(const FrameKey&, const FrameKey&) = default;
};

/// Whether the same lines are clipped at the same windows with the same variant.
bool isSameClipping(const FrameKey& a, const FrameKey& b);
/// Whether the lines and the size of the picture are the same.
bool isSameBase(const FrameKey& a, const FrameKey& b);
/// Whether they are seen in the same view, too.
bool isSameView(const FrameKey& a, const FrameKey& b);
/// By how many device pixels the same lines have moved from `a` to `b`, in a picture of the same
/// size. Empty if the zoom is another, or if they have not moved by whole pixels.
std::optional<QPoint> wholePixelsBetween(const FrameKey& a, const FrameKey& b);

/// Counts the changes of images that are shown, for FrameKey::images.
class ImageCount {
public:
    std::uint64_t follow(const std::vector<SeenUnderlay>& now)
    {
        if (now != last_) {
            last_ = now;
            ++count_;
        }
        return count_;
    }

private:
    std::vector<SeenUnderlay> last_;
    std::uint64_t count_ = 0;
};

/// Pieces that several owners read.
using SharedPieces = std::shared_ptr<const std::vector<clipping::Clipped>>;

class DrawingPictures;

/// All that a frame shows. It owns or shares everything, so that any thread may work on it while
/// the drawing is edited.
struct FrameWish {
    FrameKey key;
    Document document; ///< with the styles of the lines
    SceneLines lines;
    PictureOptions options{}; ///< without what key, selection and pieces hold
    std::vector<SeenUnderlay> underlays{};
    ObjectRanges selection{};
    SharedPieces differing{}; ///< may be null
    struct Graded {
        SharedPieces pieces;
        Colour colour;
    };
    std::vector<Graded> graded{};
    double ghost = 1;   ///< opacity of the removed part
    bool rough = false; ///< for a moment a frame will do that is painted sooner, if only roughly
    std::shared_ptr<DrawingPictures> drawings{}; ///< that panes share; null: none
    /// Makes what is wanted of a drawing that is not large and has no images, instead of an image,
    /// on the thread that paints; null: an image is wanted. Of a large one this would take as long
    /// for every cut, and what is made as long to be shown.
    std::function<std::shared_ptr<const void>(const Picture&)> make{};

    static constexpr std::size_t large = 25'000; ///< lines
    bool isLarge() const { return lines.size() > large; }
    bool isMade() const { return make && !isLarge() && underlays.empty(); }
    bool isImage() const { return !isMade() && !key.pixels.isEmpty(); }

    /// The options with everything, as long as the wish lives.
    PictureOptions pictureOptions() const;
    RasterOptions rasterOptions(const std::stop_token& stop) const;
};

} // namespace app
