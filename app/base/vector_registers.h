// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Clears the upper halves of the processor's vector registers, if it has any. Qt's painting leaves
/// them in use (AVX code without vzeroupper), which slows down all later SSE code: Cyrus-Beck took
/// 1.5 times as long in the turns after drawing.
void emptyUpperHalves();

} // namespace app
