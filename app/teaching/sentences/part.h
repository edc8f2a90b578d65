// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/sentences/words.h"

// Sentences that Liang-Barsky and Cyrus-Beck share: about the remaining part of a line.

namespace app::words {

/// The names of the parameters at the start and the end of the part.
struct PartNames {
    const char *start, *stop;
};

/// The current value of a variable with six significant digits.
QString knownNumber(const SentenceContext& context, const char* name);
/// "0.5 < 1": the comparison of two of them.
QString knownCompared(const SentenceContext& context, const char* one, const char* other);

/// The first steps: the whole line remains, and its extent along each axis.
QString wholeLine(const SentenceContext& context, const PartNames& names);
/// Whether a step is one of those that move the ends.
bool isEndOfPart(const SentenceContext& context);
/// Such a step.
QString endsOfPart(const SentenceContext& context, const PartNames& names);

} // namespace app::words
