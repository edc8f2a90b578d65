// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/sentences/words.h"

// Sentences about the ends of a line and the window's corners.

namespace app::words {

/// The current place of an end of the remaining part.
Point endOf(int number, const SentenceContext& context);
/// Whether an end lies strictly beyond an edge of the window.
bool isBeyond(const SentenceContext& context, int number, clipping::Edge edge);

/// Whether an end is beyond the step's edge: "End 2 lies above the window (130 > 75)" or "End 2
/// does not lie above the window (60 < 75)"; without a full stop.
QString whetherBeyond(const SentenceContext& context, int number);
/// Whether a corrected form tests the rise (`rise`) of an end that was moved in x, from its
/// original place (yi), and not its rounded place.
bool asksTheWay(const SentenceContext& context);
/// The result of such a test.
QString whetherPassed(const SentenceContext& context, int number);
/// Why nothing is visible if both ends of the original line lie beyond the step's edge or, if the
/// step has no edge, beyond any edge.
QString bothBeyond(const SentenceContext& context);
/// "the top left corner": the common corner of two edges, in either order.
QString corner(clipping::Edge one, clipping::Edge other, YAxis y);
/// "End 1 is 0001, End 2 is 1000": from the values code1 and code2.
QString outcodes(const SentenceContext& context);

/// The effect of an overflow on a test for a corner of the window; `products`: the comparison of
/// products.
QString productsTooLarge(const QString& products, const QString& corner);

/// A value of the algorithm with six significant digits; empty if there is no value of that name.
QString value(const SentenceContext& context, std::string_view name);

/// The line before the last of a corrected form: whether it moves an end back into the window.
QString held(const SentenceContext& context);
/// The visible part at the end, and whether a published form has left an end outside the window.
QString acceptedIfInside(const SentenceContext& context);
/// An addition to a rejection: that it is wrong, if a published form loses a visible line.
QString lost(const SentenceContext& context);

} // namespace app::words
