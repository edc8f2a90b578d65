// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/painted.h"
#include "app/teaching/slide.h"

#include <QByteArray>
#include <QStringList>

#include <span>

// A trace as files: for slides and papers, for scripts. The same trace is the same bytes.

namespace app {

/// What is written.
struct TraceExport {
    Specimen specimen;
    Walk walk;
    std::optional<std::size_t> only{}; ///< one step alone: an index into walk.moments
    SlideParts parts = SlideParts::All;
    Ground ground = Ground::Light;
    double scale = 1; ///< pixels of a picture for each of the slide's
    /// The steps, in their order; of a walk without any: 0, the line and the window.
    std::vector<std::size_t> steps() const;
};

/// The slide of one step. To be painted while `trace` is there.
PaintedPage slidePage(const TraceExport& trace, std::size_t step);

/// One row of the catalogue of what a trace can be saved as.
struct TraceFormat {
    std::string_view key, ending; ///< "text", ".txt" without its point; mostly the same
    QString name;                 ///< "SVG drawings, one for each step", translated
    enum class Files : std::uint8_t { One, OneAStep };
    Files files;
    bool forPeople; ///< false: text, which a terminal can show
    /// A whole file with these steps; empty if there is not enough memory.
    QByteArray (*bytes)(const TraceExport& trace, std::span<const std::size_t> steps);
};

/// Every format, in menu order.
std::span<const TraceFormat> traceFormats();
/// By its key or ending; null if there is none.
const TraceFormat* findTraceFormat(QStringView word);

/// What a file of it is called, without its ending: "matthes-drakopoulos", "skala-published".
QString traceStem(const TraceExport& trace);

/// The files that would be written to a name: NAME itself if it is one file, NAME-01.svg and so on
/// if it is one a step; in a folder they are called as the algorithm is.
QStringList tracePaths(const TraceExport& trace, const TraceFormat& format, const QString& target);

/// Those of the numbered files that are there already and would be overwritten.
QStringList existingOf(const QStringList& paths);

/// The bytes of each of the files; nothing if there is not enough memory.
std::optional<std::vector<QByteArray>> traceBytes(const TraceExport& trace,
                                                  const TraceFormat& format);

/// Writes each file; an existing one is replaced only by a whole new one. Nothing, or the sentence
/// that says which file could not be written.
std::optional<QString> writeTrace(const QStringList& paths, std::span<const QByteArray> bytes);

// How the formats that are no mere painting are written, each in a file of its own.
QByteArray traceText(const TraceExport& trace, std::span<const std::size_t> steps);
QByteArray traceJson(const TraceExport& trace, std::span<const std::size_t> steps);
QByteArray traceGif(const TraceExport& trace, std::span<const std::size_t> steps);

} // namespace app
