// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/compared_window.h"

#include <QString>

namespace app {

/// For captions: says that algorithms are compared at the page. Empty if there is a clip window.
QString atText(const ComparedWindow& window);

} // namespace app
