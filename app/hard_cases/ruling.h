// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>

namespace app {

struct HardCase;

/// What can be said of an answer. Allowed: wrong about visibility, where the contract of the
/// corrected forms lets it be; the published ones have none.
enum class Ruling : std::uint8_t {
    Right,
    Allowed,
    Lost,       ///< visible, and nothing is returned
    Shown,      ///< nothing is visible, and something is returned
    Outside,    ///< an end is not in the window
    Moved,      ///< an end is farther off than the row's ulps
    NotANumber, ///< an end is NaN or infinite
    Endless     ///< it was stopped
};

/// "lost": as in the file. The way back gives nothing for what is none.
QString keyOf(Ruling ruling);
std::optional<Ruling> findRuling(const QString& key);

/// What one variant makes of a hard case.
struct CaseAnswer {
    Variant variant{};
    std::optional<clipping::Segment> visible{};
    Ruling ruling = Ruling::Right;
    double ulps = 0;   ///< how far its ends are off, in ulps of the largest |coordinate|
    double beyond = 0; ///< how far they are outside the window, in its unit

    bool good() const { return ruling == Ruling::Right || ruling == Ruling::Allowed; }
};
CaseAnswer answerOf(const HardCase& hard, const Variant& variant);
/// Of all there are, in menu order.
std::vector<CaseAnswer> answersTo(const HardCase& hard);

/// "right", "lost", "outside the window by 2.2e−16".
QString words(const CaseAnswer& answer);
/// "(1, 1) to (0.1, 0.1)", "the point (0, 1)", "nothing", all digits that there are.
QString pieceText(const std::optional<clipping::Segment>& piece);

} // namespace app
