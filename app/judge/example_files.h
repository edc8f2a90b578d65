// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"

#include <QStringList>

namespace app::plug_in {

/// What one begins with: the header, a frame to fill in with the contract as its comment, an
/// algorithm that is right, and one that looks right and is wrong. Each says how it is compiled.
QStringList exampleNames();

/// What becomes of a file that is there already and differs from ours, such as a frame that was
/// filled in.
enum class Existing : std::uint8_t { Keep, Replace };

struct WrittenExample {
    QStringList written; ///< paths
    QStringList kept;    ///< paths of what was there and differs
};

/// Writes them into a folder.
Result<WrittenExample> writeExample(const QString& folder, Existing existing);

} // namespace app::plug_in
