// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <optional>

class QSettings;

namespace app {

/// The best attempt at a variant, stored between program starts.
struct PracticeRecord {
    int best = 0;        ///< first tries that were right, in percent of the moves, 0 to 100
    bool passed = false; ///< an attempt was passed
    friend bool operator==(const PracticeRecord&, const PracticeRecord&) = default;
};

/// Empty if nothing is stored that can be read.
std::optional<PracticeRecord> recordOf(const QSettings& settings, const Variant& variant);
/// Stores what is better than the record.
void keepRecord(QSettings& settings, const Variant& variant, PracticeRecord attempt);

} // namespace app
