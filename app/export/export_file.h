// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_drawing.h"
#include "app/formats/write_result.h"

namespace app {

/// How an export ended, and what was cut.
struct ExportResult : WriteResult {
    bool cut = false; ///< whether the area was cut at windows
    CutCounts counts{};
};

/// Makes the drawing of a job and writes it to a file, on any thread. An existing file is replaced
/// only by a complete new one. A stop request before the end leaves the disk unchanged.
ExportResult exportFile(const ExportJob& job, const QString& path, const Follower& follower = {});

/// The bytes of the file that exportFile() would write.
Result<QByteArray> exportedContent(const ExportJob& job, const Follower& follower = {});

/// The bytes that the file of a drawing will have; the error is what writing it would say. Nothing
/// is written, and the drawing is not kept in memory.
Result<qint64> exportedBytes(const ExportDrawing& drawing, const Format& format,
                             const std::stop_token& stop = {});

} // namespace app
