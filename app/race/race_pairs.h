// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race.h"

#include <QString>

namespace app {

/// The result of a race for one form of an algorithm.
struct FormResult {
    RaceRow row;
    Summary summary; ///< of its times

    bool measured() const { return !row.milliseconds.empty(); }
};

/// The forms of one algorithm that take part in a race; at least one.
struct RacePair {
    const clipping::Algorithm* algorithm = nullptr;
    std::optional<FormResult> corrected{}, published{};

    const std::optional<FormResult>& of(clipping::Form form) const
    {
        return form == clipping::Form::Published ? published : corrected;
    }
    /// The form whose findings stand for the algorithm: the published one, if it takes part.
    const FormResult& judged() const { return published ? *published : *corrected; }
    /// The form that can clip at more windows: the corrected one, if it takes part.
    const FormResult& ablest() const { return corrected ? *corrected : *published; }
};

/// One pair for each algorithm, in the order in which the algorithms come first in `rows`: that of
/// the catalogue, if all corrected forms come before the published ones.
std::vector<RacePair> pairsOf(std::span<const RaceRow> rows);

/// Whether any of the algorithms takes part in that form.
bool anyIn(std::span<const RacePair> pairs, clipping::Form form);

/// "Kodituwakku et al.": the first of three or more different names. Other names are unchanged.
QString briefName(const clipping::Algorithm& algorithm);

} // namespace app
