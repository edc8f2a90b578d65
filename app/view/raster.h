// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

#include <QImage>

namespace app {

/// A horizontal band of an image, in device pixels.
struct Band {
    int top, height;
};

/// The picture painted without a graphics card, on a transparent ground: the rows of `band`, each
/// `width` device pixels wide. `pixelRatio` is device pixels per logical one, `ghost` the opacity
/// of the removed part. Bands of one picture may be painted by several threads at a time.
QImage rasterised(const Picture& picture, int width, Band band, double pixelRatio, double ghost);

/// As many bands as are worth a thread each.
std::vector<Band> bandsOf(int height, int threads);

/// Bands put together.
QImage joined(std::span<const QImage> bands);

} // namespace app
