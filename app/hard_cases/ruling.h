// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace app {

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

} // namespace app
