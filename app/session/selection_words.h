// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// What is selected, in words: "3 objects", "group of 3 objects", "2 nodes", "nothing selected".
QString selectionText(const Session& session);

} // namespace app
