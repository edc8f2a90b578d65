// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/result.h"

#include <QStringList>

namespace app::plug_in {

/// What one begins with: the header, and an example that says how it is compiled, and one
/// that looks right and is wrong.
QStringList exampleNames();

/// Writes them into a folder, over what is called like them, and says where they are.
Result<QStringList> writeExample(const QString& folder);

} // namespace app::plug_in
