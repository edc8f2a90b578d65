// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <functional>

namespace app {

/// Visits the objects of a drawing as they are seen on its page, bottom to top, for painters and
/// file formats that huge numbers overtax: without what is hidden and fills that have no area, and
/// what reaches far beyond the page reduced to what is near it (a stroke and a fill then become two
/// objects). Most come as they are.
void visitSeen(const Document& document, const std::function<void(const Object&)>& visit);

} // namespace app
