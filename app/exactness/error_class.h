// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/exactness.h"
#include "app/view/algorithm_mark.h"

#include <QString>

namespace app {

/// One of the classes by which lines are coloured and counted.
struct ErrorClass {
    double most;  ///< largest error in ulps, in either unit; infinite for the last two
    QString name; ///< translated: "up to ½ ulp", "wrong"
    bool isWrong; ///< only the last class: wrong, not just inexact
};
/// From the best to the worst; the last class is for wrong lines.
std::span<const ErrorClass> errorClasses();
std::size_t errorClassOf(const LineExactness& line, ErrorUnit errorUnit);
/// From pale to strong on that ground; `wrong` for the class of wrong lines.
QColor errorColour(std::size_t errorClass, Ground ground, const QColor& wrong);

/// A summary of the results.
struct ErrorCounts {
    std::vector<std::size_t> classes{}; ///< lines of each class
    std::size_t lost = 0, invented = 0, notFinite = 0, outside = 0, orderMatters = 0;
    double worst = 0; ///< largest error of the lines without a fault
    std::size_t all() const;
};
ErrorCounts counted(const ExactnessResults& results, ErrorUnit errorUnit);

/// "MD: 21,345 of 21,345 visible lines are right, the worst end is 2.1 ulps off. 12 depend on
/// which end comes first."
QString sentence(const Variant& variant, const ErrorCounts& counts, ErrorUnit errorUnit);

/// The verdict on one line: "lost: 300 long …", "3.2 ulps off, outside the window". Without a
/// period.
QString verdictText(const LineExactness& line);

/// "0", "0.13", "3.5", "1,234 ulps"; with the unit.
QString errorText(double ulps);

} // namespace app
