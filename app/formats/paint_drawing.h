// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <stop_token>

class QImage;
class QPainter;

namespace app {

/// Paints all that is seen of a drawing, its page at the upper left corner. A stop request leaves
/// the rest out.
void paintOn(QImage& image, const Document& document, double pixelsPerUnit,
             const std::stop_token& stop = {});
/// The same for a printer, on which strokes and areas stay what they are.
void paintOn(QPainter& painter, const Document& document, double pixelsPerUnit,
             const std::stop_token& stop = {});

} // namespace app
