// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"

namespace app {

/// A page around all points and half the stroke widths, with a user unit of one pixel, for drawings
/// without a page; the usual page if there are no objects.
Page pageAround(const Objects& objects);

} // namespace app
