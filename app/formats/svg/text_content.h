// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/length.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/tree.h"

#include <QString>

#include <limits>
#include <vector>

namespace app::svg {

constexpr double notGiven = std::numeric_limits<double>::quiet_NaN();

/// What attributes say about one character, in user units and degrees; `notGiven`: nothing.
struct LetterPlace {
    double x = notGiven, y = notGiven, dx = notGiven, dy = notGiven, rotate = notGiven;
};

/// The characters of a <text>. Blanks are joined as SVG does, unless they are to be kept.
class TextContent {
public:
    /// `run`: the number of the element whose style they have.
    void append(const QString& text, std::size_t run, bool keepsBlanks);
    /// Leaves out a blank at the end that is not to be kept.
    void trimEnd();

    /// Applies the lists x, y, dx, dy and rotate of an element to the characters from `first` to
    /// the end; those of elements inside it come first.
    void place(const Tree& tree, Node node, qsizetype first, const Lengths& lengths,
               Report& report);

    const QString& text() const { return text_; }
    std::size_t runOf(qsizetype index) const { return runs_[std::size_t(index)]; }
    const LetterPlace& placeOf(qsizetype index) const { return places_[std::size_t(index)]; }

private:
    QString text_;
    std::vector<std::size_t> runs_;   ///< of each character
    std::vector<LetterPlace> places_; ///< of each character
    bool lastIsKept_ = false;         ///< whether a blank at the end is one that is kept
};

} // namespace app::svg
