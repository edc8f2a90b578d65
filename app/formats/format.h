// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"

#include <QIODevice>
#include <QStringList>

#include <span>
#include <stop_token>
#include <string_view>

namespace app {

/// One kind of thing that an import could not keep, and how many of it ("text", 3). A thing that
/// was kept in another way (a clipPath really cut) is a remark, not a loss.
struct Loss {
    QString what;
    int count = 1;
    bool remark = false;
    QString instead{}; ///< what is kept of it ("their lines are"); may be empty
};

/// A drawing as it came out of a file, with what the document could not hold.
struct Imported {
    Document document;
    std::vector<Loss> report;
    /// CSV: the 0-based data row that each object came from; else empty.
    std::vector<std::uint32_t> rows{};
    /// Whether the file has a page of its own. Else (CSV) the page is what is drawn, and lengths
    /// with a unit count from the user origin as bare numbers do.
    bool paged = true;
    /// Of a file without a page of its own: all that is drawn, with the page. Where nothing else is
    /// said, this is clipped.
    std::optional<clipping::Window> drawn{};
    bool lossy() const; ///< any that is not a remark: Save becomes Save as
};

struct WriteOptions {
    int precision = -1;   ///< decimals; -1: the shortest text that reads back bit for bit
    double dpi = 96;      ///< PNG
    double tolerance = 0; ///< user units; flattening where the format has no curves; 0: usual
    /// With a limited precision, numbers are rounded and then moved inward so that the decimals
    /// themselves lie in this rectangle.
    std::optional<clipping::Window> bounds{};
    /// CSV: the column `source`, one number for each object, and the rows in its order;
    /// empty: no such column, and the rows in drawing order.
    std::vector<std::uint32_t> sources{};
    /// Asked to stop before all is written: nothing on disk changes.
    std::stop_token stop{};
};

/// What a drawing is in a file: paths and curves, or separate lines, where what touches the clip
/// window in a single point counts as well.
enum class Holds : std::uint8_t { Paths, SeparateLines };

/// Whether a file can hold what is hidden, and keeps it hidden.
enum class Hides : std::uint8_t { No, Yes };

/// One row of the catalogue of file formats. A null function: cannot.
struct Format {
    std::string_view key; ///< "svg": the file name's ending and --from/--to
    QString name;         ///< "SVG drawing", translated
    Result<Imported> (*read)(QIODevice& in);
    /// Nothing, or the sentence that says what went wrong. Hidden objects and layers are left out
    /// unless the format `hides`.
    std::optional<QString> (*write)(const Document& document, QIODevice& out,
                                    const WriteOptions& options);
    Holds holds = Holds::Paths;
    Hides hides = Hides::No;
    QString limits{}; ///< the most that a file of it may hold, as it follows "at most "; or nothing
};

/// Every format, in menu order; the first is the native one.
std::span<const Format> formats();
const Format* findFormat(QStringView key);
const Format* formatOfFile(const QString& path); ///< by its ending, any case

/// Opens and reads a file, of the format that its ending says unless one is given; the sentence
/// names the file. Refuses directories and unknown endings.
Result<Imported> readFile(const QString& path, const Format* format = nullptr);

/// Writes a file, of the format that its ending says unless one is given. An existing file is
/// replaced only by a whole new one (QSaveFile); a device or a pipe is written to.
std::optional<QString> writeFile(const Document& document, const QString& path,
                                 const WriteOptions& options = {}, const Format* format = nullptr);

} // namespace app
