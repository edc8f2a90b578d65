// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"

#include <QString>

#include <vector>

namespace app {

/// The value of an option, for messages.
struct GivenValue {
    QString option; ///< without dashes
    QString text;
};

/// Throws WrongUsage: "--window 1,2: give …".
[[noreturn]] void refuse(const GivenValue& value, const QString& expected);
/// The same for comma-separated numbers, one of which may be too large.
[[noreturn]] void refuseNumbers(const GivenValue& value, const QString& expected);

/// The comma-separated lengths of `numbers`, which is a part of the value; throws WrongUsage if it
/// holds anything else.
std::vector<Length> lengthsOf(const GivenValue& value, const QString& numbers,
                              const QString& expected);

} // namespace app
