// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

namespace app {

/// The place of the label of a marker at `at`: above left of it, or else above right, below left or
/// below right; inside the canvas, and not over the box `covered`, which may be empty. If none of
/// them is free, it is above or below that box.
QRectF markerPlace(const QPointF& at, const QSizeF& label, const QSizeF& canvas,
                   const QRectF& covered);

} // namespace app
