// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

#include <QImage>

#include <functional>

namespace app {

/// Long computations call this frequently; true: stop, the result is no longer needed.
using Cancelled = std::function<bool()>;
inline bool neverCancelled() { return false; }

/// A horizontal band of an image, in device pixels.
struct Band {
    int top, height;
};

/// The options of a raster image.
struct RasterOptions {
    int width = 0;         ///< device pixels
    double pixelRatio = 1; ///< device pixels per logical pixel
    double ghost = 1;      ///< opacity of the removed part
    Cancelled cancelled = neverCancelled;
};

/// Paints the rows of `band` without a graphics card, on a transparent background. Several threads
/// may paint bands of one picture at the same time. If cancelled, the image has its full size but
/// undefined content. `base` is an image of the band above the selection and the ghost; null: none.
QImage rasterised(const Picture& picture, Band band, const RasterOptions& options,
                  const QImage& base = {});

/// The bands of an image for up to `threads` threads; each is large enough to be worth a thread.
std::vector<Band> bandsOf(int height, int threads);

} // namespace app
