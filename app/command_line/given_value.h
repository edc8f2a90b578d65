// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"

#include <QString>

#include <array>
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

/// The four comma-separated plain numbers of `numbers`, which is a part of the value; `names` is
/// their name in the error message: "X1,Y1,X2,Y2". Throws WrongUsage if it holds anything else.
std::array<double, 4> fourNumbers(const GivenValue& value, const QString& numbers,
                                  const QString& names);

/// The comma-separated lengths of `numbers`, which is a part of the value; throws WrongUsage if it
/// holds anything else.
std::vector<Length> lengthsOf(const GivenValue& value, const QString& numbers,
                              const QString& expected);

} // namespace app
