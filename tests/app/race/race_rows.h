// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race.h"

/// A row of a race that took the same time in ten rounds; 0: it was not measured.
inline app::RaceRow raceRow(const char* algorithm, clipping::Form form, double milliseconds)
{
    app::RaceRow row{.variant = {clipping::findAlgorithm(algorithm), form}};
    if (milliseconds > 0)
        row.milliseconds.assign(10, milliseconds);
    return row;
}
