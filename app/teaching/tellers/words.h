// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teller.h"

// Words that many tellers share.

namespace app::words {

/// "left of the window", "above the window", as it is seen. Not for Edge::None.
QString beyond(clipping::Edge edge, YAxis y);
/// "x" or "y": the axis across the edge.
QString axisName(clipping::Edge edge);

/// "End 1" or "End 2".
QString end(int number);
/// "(−9.0625, 75)".
QString point(const Point& p);
/// A number in six digits, in words where it is none.
QString number(double value);
/// "130 > 75", in as many digits as tell the two apart.
QString compared(double one, double other);
/// "130 > 75": the end's coordinate and the level of the edge.
QString compared(const Point& p, clipping::Edge edge, const clipping::Window& window);

/// "inside", "above left": the region that has this outcode.
QString region(unsigned code, YAxis y);
/// An edge that an outcode names; None for 0.
clipping::Edge edgeOf(unsigned code);
/// "1001 (above left)".
QString codeAndRegion(unsigned code, YAxis y);
/// The bits that are named by a value.
unsigned bits(const Telling& telling, std::string_view name);

/// How far the line goes on the other axis on the way from a point to the step's edge: `gone`, by
/// its slope if the algorithm knows that.
QString way(const Telling& telling, const QString& from, const Point& start, double gone,
            std::optional<double> slope = {});
/// An end has moved to the step's edge.
QString moved(const Telling& telling, int number);

/// What is left is visible: how much of the line that is, and from where to where.
QString accepted(const Telling& telling);

bool isPublished(const Telling& telling);
/// Whether a point lies outside the closed window.
bool isOutside(const Point& p, const clipping::Window& window);

} // namespace app::words
