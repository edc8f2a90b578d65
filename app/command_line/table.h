// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/tables/table.h"

namespace app {

/// The option --format, with what tables can be printed as.
Option tableOption();

/// The one that --format names.
TableFormat tableFormat(const Given& given);

} // namespace app
