// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

#include <QByteArray>
#include <QImage>
#include <QSizeF>
#include <QString>

#include <functional>
#include <span>

class QPainter;

// Turns anything that can be painted (charts, figures, slides) into a complete file in memory. The
// file contains no time and nothing about the machine, so the same picture gives the same bytes.

namespace app {

struct PaintedPage {
    QSizeF size; ///< in logical pixels (1/96 inch)
    std::function<void(QPainter& painter)> paint;
};

/// The title and description in a file, for people who cannot see the picture.
struct PaintedCaption {
    QString title, description;
};

QByteArray svgOf(const PaintedPage& page, const PaintedCaption& caption);
/// `scale`: pixels per logical pixel, may be less than 1. Null if memory is insufficient or the
/// image would have no pixels.
QImage imageOf(const PaintedPage& page, double scale);
/// The image as a PNG file with the caption; empty if imageOf() would return null.
QByteArray pngOf(const PaintedPage& page, const PaintedCaption& caption, double scale);
/// A PDF with one page, of its own size, for each element of `pages`.
QByteArray pdfOf(std::span<const PaintedPage> pages, const PaintedCaption& caption);

/// The position of a page on paper: centred, as large as fits (SVG's xMidYMid meet).
struct Paper {
    Point millimetres;         ///< the size of the paper
    double millimetresPerUnit; ///< the size of a user unit
    Point corner;              ///< the document point at the top left corner of the paper
};
Paper paperOf(const Page& page);

/// Why nothing can be calculated on a page, as a sentence: it has no size, or its unit is beyond
/// the range of numbers.
std::optional<QString> faultOf(const Page& page);

} // namespace app
