// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The offset for pasted copies: the first multiple of `step`, from one step on, at which no copy
/// lies on an object of the document with the same path. The search ends after a thousand steps
/// (coordinates may be so large that a step changes nothing).
Point copyOffset(const Document& document, const Objects& copies, const Point& step);

} // namespace app
