// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_drawing.h"
#include "app/tiles/sheets.h"

class QPagedPaintDevice;

namespace app {

/// Which way round the paper lies. Automatic: as needs fewer sheets; portrait if both need as many.
enum class PaperTurn : std::uint8_t { Automatic, Portrait, Landscape };

/// How a drawing is printed: always at its true size.
struct PrintChoice {
    Point paper{210, 297}; ///< in millimetres, portrait
    PaperTurn turn = PaperTurn::Automatic;
    double margin = 5;   ///< of each sheet, in millimetres, if there are several
    double overlap = 10; ///< of neighbouring sheets, in millimetres
    bool marks = true;   ///< on several sheets: where they fit together
    friend bool operator==(const PrintChoice&, const PrintChoice&) = default;
};

/// A drawing on one sheet, in its middle, or divided among several.
struct PrintSheets {
    Sheets sheets;
    bool single = false; ///< it fits, and is not cut

    int count() const { return single ? 1 : sheets.tiling.written(); }
    Point paper() const { return sheets.tiling.sheet; } ///< in millimetres, as it lies
    /// What is drawn on the sheet of this number, from 0, on a page of the paper's size.
    Document page(std::size_t number) const;
    /// The paper of each sheet, in the drawing's coordinates.
    std::vector<clipping::Window> papers() const;
};

/// Divides a drawing that was made of this source. `title` is written on each of several sheets.
/// The error is a sentence.
Result<PrintSheets> printSheets(const ExportDrawing& drawing, const PrintChoice& choice,
                                const ExportSource& source, const QString& title);

/// Writes a PDF file, exactly as large as the paper. An existing one is replaced only by a complete
/// new one.
std::optional<QString> printFile(const PrintSheets& sheets, const QString& path,
                                 const Follower& follower = {});

/// Prints on a device, on whole sheets of this paper. The error is a sentence.
std::optional<QString> printOn(QPagedPaintDevice& device, const PrintSheets& sheets,
                               const Follower& follower = {});

} // namespace app
