// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/hairlines.h"

#include <optional>
#include <vector>

namespace app {

/// Paints opaque hairlines on an image as they come, from the bottom to the top: a few of one
/// colour one by one, many of them together (hairlines.h). What lies above them is painted after
/// flush().
class HairlineRun {
public:
    /// The image must outlive it; 32 bits, premultiplied or opaque.
    explicit HairlineRun(QImage& image) : image_(image) {}

    void add(const Hairline& line, const Colour& colour);
    void flush();

private:
    static constexpr std::size_t few = 64;

    QImage& image_;
    std::vector<Hairline> lines_; ///< that are not painted yet; more than `few` are in tiles
    Colour colour_{};
    std::optional<Hairlines> tiles_;
    bool inTiles_ = false;
};

} // namespace app
