// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// Where copies go: the first multiple of `step`, from one step on, at which none of them lies on
/// an object of the document with the same path. After a thousand steps it gives up looking
/// (coordinates may be so large that a step changes nothing).
Point copyOffset(const Document& document, const Objects& copies, const Point& step);

} // namespace app
