// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/view/thumbnail.h"

#include <span>

namespace app {

/// One sample drawing that comes with the program: a line of resources/samples/index.txt.
struct Sample {
    QString key;   ///< "rosette"
    QString title; ///< "Guilloche rosette"
    QString file;  ///< a path among the program's resources
};

/// All samples, in the order of the start panel; empty if the resources are not linked in.
std::vector<Sample> samples();

/// The picture of a sample with its clip window; null if it cannot be read. May run on any thread.
QImage samplePicture(const QString& file, const QSize& points, double pixelRatio,
                     const ThumbnailColours& colours);

/// Whether a drawing is the sample of that key with no changes except to the clip windows: then
/// there is nothing to save.
bool isUnchangedSample(const QString& key, const Document& document);

} // namespace app
