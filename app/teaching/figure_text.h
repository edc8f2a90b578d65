// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

namespace app {

/// The figure in words, for people who do not see it: window, line and the sentence of the step. It
/// says nothing that the narration does not, so it gives no covered answer away.
QString figureText(const TracedLine& tracedLine, const Narration& narration, std::size_t step);

} // namespace app
