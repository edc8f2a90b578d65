// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given_value.h"
#include "app/formats/format.h"

namespace app {

/// Where lengths with a unit count from: the paper's top left corner, or the user origin in a file
/// without a page.
Point cornerOf(const Imported& imported);

/// Comma-separated numbers of an option. Plain numbers are the drawing's own coordinates; lengths
/// with a unit, such as 10mm, count from the paper's top left corner. All of them have a unit, or
/// none.
class DrawingNumbers {
public:
    /// `numbers` is a part of the value. Throws WrongUsage for anything else, and for a mixture.
    DrawingNumbers(const GivenValue& value, const QString& numbers, const QString& expected,
                   const Imported& imported);

    std::size_t size() const { return lengths_.size(); }
    /// The point of the numbers `i` and `i + 1`, in user units; throws WrongUsage if it is not
    /// finite.
    Point point(std::size_t i) const;
    double length(std::size_t i) const; ///< in user units; the same

private:
    std::vector<Length> lengths_;
    Point corner_;
    double millimetresPerUnit_;
};

} // namespace app
