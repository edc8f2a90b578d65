// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

#include <QImage>

#include <functional>

namespace app {

/// Asked in short intervals by what may take long; true: stop, the result is not wanted any more.
using Cancelled = std::function<bool()>;
inline bool neverCancelled() { return false; }

/// A horizontal band of an image, in device pixels.
struct Band {
    int top, height;
};

/// What a picture is painted for.
struct RasterOptions {
    int width = 0;         ///< device pixels
    double pixelRatio = 1; ///< device pixels per logical one
    double ghost = 1;      ///< opacity of the removed part
    Cancelled cancelled = neverCancelled;
};

/// The picture painted without a graphics card, on a transparent ground: the rows of `band`. Bands
/// of one picture may be painted by several threads at a time. Cancelled: of its size, with
/// anything in it.
QImage rasterised(const Picture& picture, Band band, const RasterOptions& options);

/// As many bands as are worth a thread each.
std::vector<Band> bandsOf(int height, int threads);

/// Bands put together.
QImage joined(std::span<const QImage> bands);

} // namespace app
