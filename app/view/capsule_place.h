// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace app {

/// The surroundings of a thing on the canvas, beside which its bar of controls is to be placed. All
/// in logical pixels.
struct CapsuleRoom {
    QSizeF canvas{};
    QRectF box{};                      ///< of the thing that it belongs to, with its handles
    std::vector<QRectF> covered{};     ///< what must be seen: handles, names, small neighbours
    std::optional<QPointF> released{}; ///< where the pointer was let go
};

/// The top left corner of a bar of this size: below the box or above it, whichever is nearer to the
/// pointer, or else inside, at its lower edge. Empty: of the box no more than a handle is seen, or
/// there is no place at which everything else is.
std::optional<QPointF> capsulePlace(const QSizeF& size, const CapsuleRoom& room);

} // namespace app
