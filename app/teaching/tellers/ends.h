// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/tellers/words.h"

// What the tellers say of the ends of a line, and of the window's corners.

namespace app::words {

/// Where an end of what is left is at a step.
Point endOf(int number, const Telling& telling);
/// Whether it lies strictly beyond an edge of the window.
bool isBeyond(const Telling& telling, int number, clipping::Edge edge);

/// The answer to whether an end is beyond the step's edge: "End 2 lies above the window (130 > 75)"
/// or "End 2 does not lie above the window (60 < 75)"; without a full stop.
QString whetherBeyond(const Telling& telling, int number);
/// Whether a corrected form's test is about the way that an end moved in x has risen (rise), from
/// where it was given (yi), and not about the rounded place.
bool asksTheWay(const Telling& telling);
/// The answer to such a test.
QString whetherPassed(const Telling& telling, int number);
/// Why nothing is visible if both ends of the given line lie beyond the step's edge or, where that
/// is none, beyond any.
QString bothBeyond(const Telling& telling);
/// "the top left corner": where two edges meet, in either order.
QString corner(clipping::Edge one, clipping::Edge other, YAxis y);
/// "End 1 is 0001, End 2 is 1000": of the values code1 and code2.
QString outcodes(const Telling& telling);

/// What an overflow means for a question about a corner of the window; `products`: their
/// comparison.
QString productsTooLarge(const QString& products, const QString& corner);

/// A value that the algorithm had at hand, in six digits; empty: it has none of that name.
QString value(const Telling& telling, std::string_view name);

/// A corrected form's line before the last: whether it moves an end back into the window.
QString held(const Telling& telling);
/// What is visible at the end, and whether a published form has left an end outside the window.
QString acceptedIfInside(const Telling& telling);
/// To be added to a rejection: that it is wrong, where a published form loses what is visible.
QString lost(const Telling& telling);

} // namespace app::words
