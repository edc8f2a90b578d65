// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Clips from 1 to 100 segments a call, with the row `exact`, its `clipAll` and that of clip.h, and
/// prints their times a segment beside those of a plain loop over `clip`. Whether all found the
/// same number of pieces.
bool printFew(int rounds);
