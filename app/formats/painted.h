// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSizeF>
#include <QString>

#include <functional>
#include <span>

class QPainter;

// Whatever can be painted, as a whole file in memory: charts, figures, slides. What is painted goes
// in with nothing of its own about time or machine, so the same picture is the same bytes.

namespace app {

struct PaintedPage {
    QSizeF size; ///< in logical pixels (1/96 inch)
    std::function<void(QPainter& painter)> paint;
};

/// What a file says of itself to those who do not see it.
struct PaintedCaption {
    QString title, description;
};

QByteArray svgOf(const PaintedPage& page, const PaintedCaption& caption);
/// `scale`: pixels for each logical one, which may be less than 1. Null if there is not enough
/// memory, or nothing left of it.
QImage imageOf(const PaintedPage& page, double scale);
/// The same as a file, with the caption; empty where that is null.
QByteArray pngOf(const PaintedPage& page, const PaintedCaption& caption, double scale);
/// A page for each, as large as it says.
QByteArray pdfOf(std::span<const PaintedPage> pages, const PaintedCaption& caption);

} // namespace app
