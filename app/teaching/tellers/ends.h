// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/tellers/words.h"

// Sentences about the ends of a line and the window's corners.

namespace app::words {

/// The current place of an end of the remaining part.
Point endOf(int number, const Telling& telling);
/// Whether an end lies strictly beyond an edge of the window.
bool isBeyond(const Telling& telling, int number, clipping::Edge edge);

/// Whether an end is beyond the step's edge: "End 2 lies above the window (130 > 75)" or "End 2
/// does not lie above the window (60 < 75)"; without a full stop.
QString whetherBeyond(const Telling& telling, int number);
/// Whether a corrected form tests the rise (`rise`) of an end that was moved in x, from its
/// original place (yi), and not its rounded place.
bool asksTheWay(const Telling& telling);
/// The result of such a test.
QString whetherPassed(const Telling& telling, int number);
/// Why nothing is visible if both ends of the original line lie beyond the step's edge or, if the
/// step has no edge, beyond any edge.
QString bothBeyond(const Telling& telling);
/// "the top left corner": the common corner of two edges, in either order.
QString corner(clipping::Edge one, clipping::Edge other, YAxis y);
/// "End 1 is 0001, End 2 is 1000": from the values code1 and code2.
QString outcodes(const Telling& telling);

/// The effect of an overflow on a test for a corner of the window; `products`: the comparison of
/// products.
QString productsTooLarge(const QString& products, const QString& corner);

/// A value of the algorithm with six significant digits; empty if there is no value of that name.
QString value(const Telling& telling, std::string_view name);

/// The line before the last of a corrected form: whether it moves an end back into the window.
QString held(const Telling& telling);
/// The visible part at the end, and whether a published form has left an end outside the window.
QString acceptedIfInside(const Telling& telling);
/// An addition to a rejection: that it is wrong, if a published form loses a visible line.
QString lost(const Telling& telling);

} // namespace app::words
