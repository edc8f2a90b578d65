// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/tellers/words.h"

// Sentences that Liang-Barsky and Cyrus-Beck share: of the part of a line that is left.

namespace app::words {

/// The names of the parameters where the part begins and ends, and the line of the pseudo-code that
/// asks whether End 2 has to move.
struct PartNames {
    const char *start, *stop;
    int line;
};

/// A value that is known by now, in six digits.
QString knownNumber(const Telling& telling, const char* name);
/// "0.5 < 1": two of them.
QString knownCompared(const Telling& telling, const char* one, const char* other);

/// The first steps: the whole line is left, and how far it goes along each axis.
QString wholeLine(const Telling& telling, const PartNames& names);
/// The steps from `names.line` on but for the last, which move the ends.
QString endsOfPart(const Telling& telling, const PartNames& names);

} // namespace app::words
