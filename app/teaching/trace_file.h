// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/painted.h"
#include "app/teaching/slide.h"

#include <QByteArray>
#include <QStringList>

#include <span>

// A trace as files: for slides and papers, for scripts. Equal traces give equal bytes.

namespace app {

/// What is exported.
struct TraceExport {
    TracedLine tracedLine;
    Narration narration;
    std::optional<std::size_t> only{}; ///< only this step: an index into narration.steps
    SlideParts parts = SlideParts::All;
    Ground ground = Ground::Light;
    double scale = 1; ///< pixels of the image for each pixel of the slide
    /// The steps in order; for a trace without steps: 0, which shows the line and the window.
    std::vector<std::size_t> steps() const;
};

/// The slide of one step. `trace` must outlive the result.
PaintedPage slidePage(const TraceExport& trace, std::size_t step);

/// One row of the catalogue of file formats of a trace.
struct TraceFormat {
    std::string_view key, ending; ///< "text", ".txt" without its dot; usually equal
    QString name;                 ///< "SVG drawings, one for each step", translated
    enum class Files : std::uint8_t { One, OneAStep };
    Files files;
    bool forPeople; ///< false: text, which a terminal can show
    /// A whole file with these steps; empty if there is not enough memory.
    QByteArray (*bytes)(const TraceExport& trace, std::span<const std::size_t> steps);
};

/// Every format, in menu order.
std::span<const TraceFormat> traceFormats();
/// Finds a format by its key or ending; null if there is none.
const TraceFormat* findTraceFormat(QStringView word);

/// The file's name without its ending: "matthes-drakopoulos", "skala-published".
QString traceStem(const TraceExport& trace);

/// The files that would be written to `target`: the target itself if there is only one file, or
/// NAME-01.svg and so on if each step has its own; in a folder they are named after the algorithm.
QStringList tracePaths(const TraceExport& trace, const TraceFormat& format, const QString& target);

/// The numbered files that exist already and would be overwritten.
QStringList existingOf(const QStringList& paths);

/// The bytes of each file; empty if there is not enough memory.
std::optional<std::vector<QByteArray>> traceBytes(const TraceExport& trace,
                                                  const TraceFormat& format);

/// Writes each file; replaces an existing file only by a complete new one. Empty, or a sentence
/// that names the file that could not be written.
std::optional<QString> writeTrace(const QStringList& paths, std::span<const QByteArray> bytes);

// Formats that are not pictures, one file each.
QByteArray traceText(const TraceExport& trace, std::span<const std::size_t> steps);
QByteArray traceJson(const TraceExport& trace, std::span<const std::size_t> steps);
QByteArray traceGif(const TraceExport& trace, std::span<const std::size_t> steps);
QByteArray traceHtml(const TraceExport& trace, std::span<const std::size_t> steps);

} // namespace app
