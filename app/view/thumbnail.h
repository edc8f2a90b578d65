// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QColor>
#include <QImage>

namespace app {

/// The colours of a thumbnail.
struct ThumbnailColours {
    QColor page, accent;
    double ghost; ///< opacity of the part that the windows remove
};

/// A picture of a document with its clip windows, clipped by the library, in its own colours.
/// `points` is its size in logical pixels. Needs no screen and may run on any thread.
QImage thumbnail(const Document& document, const QSize& points, double pixelRatio,
                 const ThumbnailColours& colours);

} // namespace app
