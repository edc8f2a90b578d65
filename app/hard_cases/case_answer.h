// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/hard_cases/hard_case.h"

namespace app {

/// The answer of one variant to a hard case.
struct CaseAnswer {
    Variant variant{};
    std::optional<clipping::Segment> visible{};
    Ruling ruling = Ruling::Right;
    double ulps = 0;   ///< the error of its ends, in ulps of the largest |coordinate|
    double beyond = 0; ///< how far its ends are outside the window, in units of the case

    bool good() const { return ruling == Ruling::Right || ruling == Ruling::Allowed; }
};
CaseAnswer answerOf(const HardCase& hard, const Variant& variant);
/// The answers of all variants, in menu order.
std::vector<CaseAnswer> answersTo(const HardCase& hard);

/// "right", "lost", "outside the window by 2.2e−16".
QString answerText(const CaseAnswer& answer);
/// "(1, 1) to (0.1, 0.1)", "the point (0, 1)", "nothing"; with all digits.
QString pieceText(const std::optional<clipping::Segment>& piece);

} // namespace app
