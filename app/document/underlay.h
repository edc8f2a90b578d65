// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/image_file.h"

#include <QString>

#include <memory>
#include <vector>

namespace app {

/// An image below the line art of a layer. It is seen and written, but it is no object: nothing
/// selects, moves or changes it.
struct Underlay {
    std::shared_ptr<const ImageFile> file; ///< not null
    /// From pixels, counted from the upper left corner, to the drawing; `from` is 0.
    AffineMap place{};
    /// A convex polygon of the drawing, outside which the image is not seen; empty: all is seen.
    std::vector<Point> clip{};
    double opacity = 1;
    QString svgId{}; ///< the SVG id of the image

    friend bool operator==(const Underlay& a, const Underlay& b)
    {
        return (a.file == b.file || *a.file == *b.file) && a.place == b.place && a.clip == b.clip
               && a.opacity == b.opacity && a.svgId == b.svgId;
    }
};

/// The corners of what is seen of an underlay.
std::vector<Point> outlineOf(const Underlay& underlay);

/// The part of a convex polygon inside another one; empty if it has no area. The corners of
/// both may run either way round.
std::vector<Point> commonArea(std::vector<Point> polygon, const std::vector<Point>& other);
std::vector<Point> cornersOfBox(const clipping::Window& window);

/// Leaves of an underlay what is inside a convex polygon. False: nothing, and it stays as it was.
bool cut(Underlay& underlay, const std::vector<Point>& inside);

/// An underlay, or none. Copies share it, and owners compare what they hold.
class SharedUnderlay {
public:
    SharedUnderlay() = default;
    SharedUnderlay(Underlay underlay) : at_(std::make_shared<const Underlay>(std::move(underlay)))
    {
    }
    explicit operator bool() const { return bool(at_); }
    const Underlay& operator*() const { return *at_; }
    const Underlay* operator->() const { return at_.get(); }
    friend bool operator==(const SharedUnderlay& a, const SharedUnderlay& b)
    {
        return a.at_ == b.at_ || (a.at_ && b.at_ && *a.at_ == *b.at_);
    }

private:
    std::shared_ptr<const Underlay> at_;
};

class Document;

/// An underlay that is shown, and how many objects of the document lie below it.
struct SeenUnderlay {
    std::size_t below;
    SharedUnderlay underlay;
    friend bool operator==(const SeenUnderlay&, const SeenUnderlay&) = default;
};
/// All that are shown, from bottom to top. O(1) without underlays.
std::vector<SeenUnderlay> seenUnderlays(const Document& document);

} // namespace app
