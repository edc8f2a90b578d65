// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

namespace app {

/// What times are taken with.
struct Clock {
    QString name;                        ///< for the record
    std::function<double()> nanoseconds; ///< since some moment; never goes back
};
Clock wallClock();
/// The processor time of the thread that asks: what other programs take does not count, so it is
/// the fairer one, but what threads and graphics cards do for the thread does not count either.
Clock processorClock();

} // namespace app
