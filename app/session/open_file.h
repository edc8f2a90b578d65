// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/scene/scene.h"

namespace app {

/// A file's drawing and the blocks of its lines, as Session::load() takes them; or why it cannot be
/// opened: a sentence that names the file and says what to do.
struct OpenedFile {
    Result<Imported> drawing;
    std::optional<SceneBlockCache> blocks{}; ///< of a drawing that was read
};

/// Reads the file and nothing else: asks nobody, watches nothing, changes no open drawing. Any
/// thread may call it. There is enough memory to show what it returns.
OpenedFile openFile(const QString& path);

} // namespace app
