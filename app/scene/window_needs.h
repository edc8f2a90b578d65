// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/scene/region.h"

#include <QString>

namespace app {

// Which algorithms can clip at a clip window of which shape. Nothing here names an algorithm: the
// library's catalogues say which forms a row has.

/// The kinds of shape that an algorithm must be able to clip at, the easiest first.
enum class WindowNeeds : std::uint8_t { Rectangle, RotatedRectangle, ConvexPolygon, AnyArea };

WindowNeeds needsOf(const ClipRegion::Step& step);

/// A clip window as far as algorithms are concerned.
struct NamedNeeds {
    QString name;
    WindowNeeds needs = WindowNeeds::Rectangle;

    friend bool operator==(const NamedNeeds&, const NamedNeeds&) = default;
};
/// The most that any window of a region demands.
WindowNeeds needsOf(const ClipRegion& region);

/// Whether an algorithm can clip at such a window.
bool canClip(const clipping::Algorithm& algorithm, WindowNeeds needs);
/// Why it cannot, in two words: "rectangles only", "convex only"; empty if it can.
QString limitText(const clipping::Algorithm& algorithm, WindowNeeds needs);

/// The same of a variant: published forms clip at rectangles only.
QString limitText(const Variant& variant, WindowNeeds needs);

/// Its name for menus, with the reason: "Liang-Barsky (rectangles only)".
QString limitedName(const clipping::Algorithm& algorithm, WindowNeeds needs);

/// The variant that clips at a region if `wanted` is chosen: itself if it can clip at every
/// window, else its corrected form if that can, else the row `exact`. Not for misprints.
Variant usedAt(const ClipRegion& region, const Variant& wanted);
Variant usedAt(WindowNeeds needs, const Variant& wanted);

/// Says what is used instead and why: "Exact is used instead: Liang-Barsky clips at rectangles
/// only." Empty if the wanted variant clips.
QString insteadText(WindowNeeds needs, const Variant& wanted);

/// What a window is, for headings: "rectangle", "convex, 64 edges", "concave, 10 edges".
QString shapeText(const ClipRegion::Step& step);

} // namespace app
