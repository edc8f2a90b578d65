// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/underlay.h"

#include <QImage>

class QPainter;

namespace app {

/// The pixels of an image file, `level` times halved; null if it is damaged. The latest ones are
/// kept, up to 256 MB and one more. For any thread but that of a screen: a large image takes a
/// second.
QImage pixelsOf(const std::shared_ptr<const ImageFile>& file, int level = 0);

/// Whether the whole file can be read; nothing is kept. As slow.
bool isReadable(const ImageFile& file);

/// Paints an underlay with a painter of the drawing's coordinates, from no more pixels than can be
/// seen. Decodes it on this thread. `opacity`: in addition to its own.
void paintUnderlay(QPainter& painter, const Underlay& underlay, double opacity = 1);

} // namespace app
