// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/view/frame_parts.h"

#include <functional>
#include <memory>

class QThreadPool;

namespace app {

/// Paints a band; several threads call it at the same time.
using PaintBand = std::function<QImage(Band)>;

constexpr int seenEarly = 8; ///< bands of each thread for what takes long

/// An image, painted in bands by the calling thread and by those of `helpers` that are free.
/// Each band is put into `parts` as soon as it is finished. `each` is the number of bands for each
/// thread: of several the first are seen early, but what every band goes through takes longer. If a
/// stop is requested, the result is of no use.
QImage paintedInBands(PaintBand paint, int height, int each, const Follower& follower,
                      const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers);

} // namespace app
