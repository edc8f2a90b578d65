// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <functional>

namespace app {

/// Visits the objects of a drawing as they appear on its page, from bottom to top, for painters and
/// file formats that cannot handle huge numbers. Hidden objects and fills without area are left
/// out. An object that reaches far beyond the page is reduced to the part near it (its fill and
/// stroke then become two objects). Most objects are passed unchanged. The images of layers are
/// visited among them.
void visitSeen(const Document& document, const std::function<void(const Object&)>& visit,
               const std::function<void(const Underlay&)>& visitImage);

} // namespace app
