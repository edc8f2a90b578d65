// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <iterator>
#include <utility>

/// Returns the same range, for a loop over results: `for (const QString& link : notEmpty(links))`.
/// Fails the test if the range is empty, because a loop that checks nothing would pass. The place
/// is the caller's (clang 14 has no std::source_location).
template <class Range>
Range notEmpty(Range&& range, const char* file = __builtin_FILE(), int line = __builtin_LINE())
{
    if (std::empty(range))
        QTest::qFail("There is nothing to loop over", file, line);
    return std::forward<Range>(range);
}
