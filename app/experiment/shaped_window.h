// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/scene/region.h"

#include <QString>

namespace app {

/// A clip window of an experiment that is a rotated rectangle or a convex polygon. Its lines are
/// timed as a whole: by class, with single precision or on several threads they are not.
struct ShapedWindow {
    ClipRegion region; ///< one window that adds
    QString text;      ///< as `clearcut bench -w` accepts it
    const ClipRegion::Step& step() const { return region.steps.front(); }
};

/// The window as such; null if it is a rectangle along the axes. Its refusal is empty, or says why
/// no algorithm is timed at it: it is not convex.
std::shared_ptr<const ShapedWindow> shapedWindow(const ClipWindow& window, const Page& page,
                                                 const QString& text = {});
QString refusalOf(const ShapedWindow& window);

/// Clips lines as `clipping::Functions::clipAll` does, with a variant that `withoutUnable` leaves:
/// with its form for polygons, if it has one; else it turns the lines into the rectangle's frame.
std::size_t clipAllAt(const ShapedWindow& window, const Variant& variant,
                      std::span<const clipping::Segment> in, std::span<clipping::Clipped> out);

/// The variants that can clip at the window.
std::vector<Variant> withoutUnable(const ShapedWindow& window, std::vector<Variant> variants);
/// "Left out, because they clip at rectangles only: CS and LB." Empty if all can.
QString unableText(const ShapedWindow& window, std::span<const Variant> variants);

} // namespace app
