// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <iterator>
#include <source_location>

/// The same range, for a loop over what was found: `for (const QString& link : notEmpty(links))`.
/// The test fails if there is nothing in it, for a loop that checks nothing would pass.
template <class Range>
Range notEmpty(Range&& range, std::source_location place = std::source_location::current())
{
    if (std::empty(range))
        QTest::qFail("There is nothing to loop over", place.file_name(), int(place.line()));
    return std::forward<Range>(range);
}
