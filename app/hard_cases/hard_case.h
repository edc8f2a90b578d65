// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "clipping/geometry.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

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

/// One entry of resources/hard_cases/hard_cases.json: a line and a window at which algorithms fail
/// or failed.
struct HardCase {
    QString key;    ///< "plotink-40"
    QString title;  ///< "A plotter that never starts"
    QString origin; ///< where it was found: "plotink #40"; our own: "ours"
    QString link;   ///< the address of the origin; may be empty
    QString why;    ///< why it is hard: one or two sentences
    clipping::Segment line{};
    clipping::Window window{};
    /// The exact visible part, each coordinate rounded once. Tests compare it with exact arithmetic
    /// that shares no code with the library.
    std::optional<clipping::Segment> visible{};
    /// Which variants fail, by keyOf(variant), and how. All other variants are right; corrected
    /// forms always are.
    std::vector<std::pair<QString, Ruling>> faults{};

    bool isOurs() const { return link.isEmpty(); }
};

/// All hard cases, in the order of the gallery.
const std::vector<HardCase>& hardCases();
/// The case with that key; null if there is none.
const HardCase* findHardCase(const QString& key);

/// Reads a file of hard cases; or returns a sentence that says which entry is wrong.
Result<std::vector<HardCase>> readHardCases(const QByteArray& json);

} // namespace app
