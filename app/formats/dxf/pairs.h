// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <string_view>

namespace app::dxf {

/// A group of a DXF file: two lines, a code that says what the value means, and the value.
struct Pair {
    int code;
    std::string_view value; ///< without blanks around it, unless it is a text (1 or 3)
};

std::string_view withoutBlanks(std::string_view text); ///< around it

/// Reads the pairs of a file in memory, one after another. A copy continues at the same place.
class Pairs {
public:
    explicit Pairs(std::string_view text) : rest_(text) {}

    /// The next pair. Comments are skipped. False at the end, and at what is no pair.
    bool next(Pair& pair);
    /// Whether the last call found something that is no pair, or only half of one.
    bool damaged() const { return damaged_; }
    qint64 line() const { return line_; } ///< of the last pair's code, or of the damage

private:
    std::string_view takeLine();

    std::string_view rest_;
    qint64 line_ = 0, lines_ = 0; ///< the lines read so far
    bool damaged_ = false;
};

} // namespace app::dxf
