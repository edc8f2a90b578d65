// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/export/export_area.h"

namespace app {

/// An export that a person has chosen.
struct ExportJob {
    ExportSource source;
    ExportChoice choice;
};

/// The drawing that is written, and what it is.
struct ExportDrawing {
    Document document; ///< without clip windows and guides, on its paper
    bool cut = false;  ///< at windows
    CutCounts counts{};
    WriteOptions options{};
    QStringList losses{}; ///< what the file cannot hold, a remark each
};

/// Cuts and selects what the job says, on any thread. The error is a sentence. When a stop is
/// requested, the result is of no use.
Result<ExportDrawing> exportDrawing(const ExportJob& job, const Follower& follower = {});

/// What is in a drawing that is exported.
struct ExportFacts {
    std::size_t paths = 0;  ///< objects
    std::size_t layers = 0; ///< that have some of them
    double length = 0;      ///< of all strokes, in millimetres on paper
    Point paper{};          ///< its size in millimetres
    Point pixels{};         ///< of a picture; 0: it is none
};
ExportFacts factsOf(const ExportDrawing& drawing, const Format& format);

} // namespace app
