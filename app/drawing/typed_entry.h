// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/number.h"
#include "app/document/path.h"

#include <optional>
#include <variant>

namespace app {

/// The kind of a number of a gesture. A factor is 1.5 or 150%, a count a whole number of corners, a
/// share 0.4, 40 or 40%.
enum class Quantity : std::uint8_t { Length, Angle, Coordinate, Factor, Count, Share };

/// A number for the field in which it is typed.
struct NumberEntry {
    double value;
};
/// "10,20", "10;20": a point.
struct PointEntry {
    /// Usual: from the second point of a gesture on, relative to the one before it.
    enum class Origin : std::uint8_t { Usual, Absolute, Relative };
    Point point;
    Origin origin; ///< "#10,20": Absolute; "@10,20": Relative
};
/// "30<45": a length and an angle. "<45": only the angle.
struct PolarEntry {
    std::optional<double> length;
    double angle;
};
constexpr int mostCopies = 10'000; ///< that can be asked for at once

/// "5x": the same step five times. "5/": five equal parts of it.
struct RepeatEntry {
    enum class How : std::uint8_t { Times, Parts };
    int count;
    How how;
    friend bool operator==(const RepeatEntry&, const RepeatEntry&) = default;
};
using Entry = std::variant<NumberEntry, PointEntry, PolarEntry, RepeatEntry>;

/// Reads what a person typed during a gesture. Lengths may have units and be sums ("10+5", "1in")
/// and become user units; angles are degrees, with or without "°". Where the locale's decimal point
/// is a comma, only ";" separates coordinates. The error is one sentence.
Result<Entry> readEntry(const QString& text, Quantity quantity, const Scale& scale,
                        const QLocale& locale = {});

} // namespace app
