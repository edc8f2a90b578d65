// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace app {

/// Where the controls of what is chosen stand.
enum class CapsuleHome : std::uint8_t { AtObject, InBar, Off };

struct CapsuleHomeInfo {
    CapsuleHome home;
    std::string_view key; ///< in settings and commands
    QString name;
};
/// All of them, in the order of CapsuleHome.
std::span<const CapsuleHomeInfo> capsuleHomes();
/// From a saved setting; of any other text: at the object.
CapsuleHome capsuleHomeOf(const QString& key);

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
