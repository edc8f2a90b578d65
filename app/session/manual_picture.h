// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/thumbnail.h"

#include <QFont>
#include <QPointF>

#include <optional>
#include <vector>

namespace app {

/// A picture of a page of the manual that the program draws: a sample with its clip window, and
/// numbered discs where the steps of the text are.
struct ManualPicture {
    struct Disc {
        int number;
        QPointF at; ///< from 0 to 1 of the picture's width and height
    };
    QString file; ///< of the sample
    std::vector<Disc> discs{};
};

/// How the discs and the frame of the picture look.
struct DiscLook {
    QColor ground, text, frame;
    QFont font;
    friend bool operator==(const DiscLook&, const DiscLook&) = default;
};

/// What an address such as "sample:landscape?3=20,40&4=50,80" means: the discs by their numbers, at
/// hundredths of the picture. Empty: it is none, or it is wrong.
std::optional<ManualPicture> manualPicture(const QString& address);
QSize manualPictureSize(int width); ///< of every such picture
/// May run on any thread. `points` is its size in logical pixels.
QImage painted(const ManualPicture& picture, const QSize& points, double pixelRatio,
               const ThumbnailColours& colours, const DiscLook& discs);

} // namespace app
