// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

namespace app {

/// The contents of a file; empty if it cannot be read.
std::string contentsOf(const QString& path, qint64 most = std::numeric_limits<qint64>::max());

/// How far records were followed.
struct Reach {
    std::uint64_t end; ///< the number of the next record
    bool whole;        ///< all bytes of the logs were records, all of which were followed
};
/// Calls follow(record) for each record from number `next` on, in the log of this generation and
/// the following ones, until one is missing or damaged, or follow() returns false.
Reach forEachRecord(const QString& folder, int generation, std::uint64_t next,
                    const std::function<bool(std::string_view)>& follow);

} // namespace app
