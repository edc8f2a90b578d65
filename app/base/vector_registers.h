// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Empties the upper halves of this processor's vector registers, if it has such. Qt's painting
/// leaves something in them (AVX code without vzeroupper), and whatever was compiled for SSE is
/// slowed down from then on: Cyrus-Beck took 1.5 times as long in the turns after drawing.
void emptyUpperHalves();

} // namespace app
