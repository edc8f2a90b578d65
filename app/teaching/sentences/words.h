// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teaching.h"

// Words that many sentences share.

namespace app {

} // namespace app

namespace app::words {

/// "left of the window", "above the window", as seen on screen. Not for Edge::NoEdge.
QString beyond(clipping::Edge edge, YAxis y);
/// "x" or "y": the axis perpendicular to the edge.
QString axisName(clipping::Edge edge);

/// "End 1" or "End 2".
QString end(int number);
/// "(−9.0625, 75)".
QString point(const Point& p);
/// A number with six significant digits, or words for NaN and infinity.
QString number(double value);
/// "130 > 75", with enough digits to tell the two apart.
QString compared(double one, double other);
/// "130 > 75": the end's coordinate and that of the edge.
QString compared(const Point& p, clipping::Edge edge, const clipping::Window& window);

/// An edge whose bit is set in an outcode; None for 0.
clipping::Edge edgeOf(unsigned code);
/// "1001 (above left)".
QString codeAndRegion(unsigned code, YAxis y);
/// The bits in a value of that name.
unsigned bits(const SentenceContext& context, std::string_view name);

/// The way along the other axis from a point to the step's edge: `gone`, computed from the slope if
/// the algorithm knows it.
QString way(const SentenceContext& context, const QString& from, const Point& start, double gone,
            std::optional<double> slope = {});
/// The move of an end to the step's edge.
QString moved(const SentenceContext& context, int number);

/// The accepted part: how much of the line it is, and its ends.
QString accepted(const SentenceContext& context);

bool isPublished(const SentenceContext& context);
/// Whether a point lies outside the closed window.
bool isOutside(const Point& p, const clipping::Window& window);

} // namespace app::words
