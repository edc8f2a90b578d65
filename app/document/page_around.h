// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"

namespace app {

/// The rectangle around all points and half the strokes, a user unit one pixel, for drawings that
/// do not tell their page; the usual page if nothing is there.
Page pageAround(const Objects& objects);

} // namespace app
