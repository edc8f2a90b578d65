// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"

#include <QStringList>

namespace app::plug_in {

/// The files to start from: the header, a template with the contract as its comment, a correct
/// algorithm, and one that looks correct but is wrong. Each says how to compile it.
QStringList exampleNames();

/// What happens to an existing file that differs, e.g. a template that was filled in.
enum class Existing : std::uint8_t { Keep, Replace };

struct WrittenExample {
    QStringList written; ///< paths
    QStringList kept;    ///< paths of existing files that differ
};

/// Writes the example files into a folder.
Result<WrittenExample> writeExample(const QString& folder, Existing existing);

} // namespace app::plug_in
