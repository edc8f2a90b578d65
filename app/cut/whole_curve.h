// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"
#include "app/document/bezier.h"

#include <optional>

namespace app {

/// The curve that was divided into these two, as programs do that add a node to it; empty: they
/// are not parts of one.
std::optional<Bezier> joined(const Bezier& first, const Bezier& second);

/// Whether a segment of a path and the next one are parts of one divided curve.
bool goesOnAfter(const Subpath& path, std::size_t segment);

struct DrawnEllipse {
    EllipseArc ellipse;
    /// Any curve with handles of equal length is near to some ellipse. Certainly drawn as one are
    /// parts of circles, quarters between the axes, and those with another part of the ellipse
    /// beside them.
    bool isCertain;
};
/// The ellipse of which a curve of a path, with those of its neighbours that were divided off it,
/// is a part.
std::optional<DrawnEllipse> ellipseAt(const Subpath& path, std::size_t segment);

} // namespace app
