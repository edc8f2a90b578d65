// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QColor>
#include <QImage>

namespace app {

/// The colours of a small picture of a drawing.
struct ThumbnailColours {
    QColor page, accent;
    double ghost; ///< opacity of what the windows remove
};

/// A document with its clip windows, really clipped by the library; `points` in size, each as many
/// pixels wide as the ratio says. Takes no screen: may be made on any thread.
QImage thumbnail(const Document& document, const QSize& points, double pixelRatio,
                 const ThumbnailColours& colours);

} // namespace app
