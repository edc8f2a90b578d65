// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>

namespace app {

struct HardCase;

/// The judgement of an answer. Allowed: wrong visibility within the bounds of the contract, which
/// only corrected forms have.
enum class Ruling : std::uint8_t {
    Right,
    Allowed,
    Lost,       ///< visible, but nothing is returned
    Shown,      ///< nothing is visible, but something is returned
    Outside,    ///< an end is not in the window
    Moved,      ///< an end is farther off than the algorithm's bound in ulps
    NotANumber, ///< an end is NaN or infinite
    DidNotEnd   ///< it was stopped
};

/// "lost": as in the file. findRuling is the inverse; empty if there is no such key.
QString keyOf(Ruling ruling);
std::optional<Ruling> findRuling(const QString& key);

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
QString words(const CaseAnswer& answer);
/// "(1, 1) to (0.1, 0.1)", "the point (0, 1)", "nothing"; with all digits.
QString pieceText(const std::optional<clipping::Segment>& piece);

} // namespace app
