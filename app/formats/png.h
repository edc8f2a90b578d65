// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

namespace app {

/// The pixels of a picture of a page, across and down: whole numbers, at least 1.
Point pixelsOf(const Page& page, double dpi);

} // namespace app
