// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/hard_cases/ruling.h"

#include <QByteArray>

namespace app {

/// One entry of resources/zoo/zoo.json: a line and a window that algorithms fail at, or failed.
struct HardCase {
    QString key;    ///< "plotink-40"
    QString title;  ///< "A plotter that never starts"
    QString origin; ///< where it was met: "plotink #40"; of our own: "ours"
    QString link;   ///< the address of the origin; empty: it has none
    QString why;    ///< what is hard about it: a sentence or two
    clipping::Segment line{};
    clipping::Window window{};
    /// What is truly visible, each coordinate rounded once. Tests compare it with exact
    /// arithmetic that shares nothing with the library.
    std::optional<clipping::Segment> visible{};
    /// What goes wrong, and how, by keyOf(variant). All others are right; corrected forms always.
    std::vector<std::pair<QString, Ruling>> faults{};

    bool isOurs() const { return link.isEmpty(); }
};

/// All of them, in the order of the gallery.
const std::vector<HardCase>& hardCases();
/// The one with that key; null if there is none.
const HardCase* findHardCase(const QString& key);

/// Reads such a file; or the sentence that says which entry is wrong.
Result<std::vector<HardCase>> readHardCases(const QByteArray& json);

} // namespace app
