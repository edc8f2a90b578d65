// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"
#include "app/formats/projection.h"

#include <QIODevice>
#include <QStringList>

#include <span>
#include <stop_token>
#include <string_view>

namespace app {

/// A kind of content that an import could not keep, and how often it occurred ("text", 3). Content
/// that was kept in another form (a clipPath that was applied) is a remark, not a loss.
struct Loss {
    QString what;
    int count = 1;
    bool remark = false;
    QString instead{}; ///< what is kept instead ("their lines are"); may be empty
    qint64 line = 0;   ///< of the file, where it occurred first; 0: none in particular
    /// A remark on something that was cut: saving over the file would lose what is no more there.
    bool cut = false;
    /// A remark on texts of which only the outlines were kept.
    bool outlined = false;
};

/// Whether a drawing with this report must be saved under another name, so that its file keeps what
/// was lost, cut or outlined.
bool mustSaveAs(const std::vector<Loss>& report);

/// What a file draws only by its name, as an area for clip windows: a clip path.
struct NamedArea {
    QString id;
    std::vector<ClipWindow> windows; ///< which unite; none: it is empty
};

/// A drawing read from a file, and a report of what the document could not keep.
struct Imported {
    Document document;
    std::vector<Loss> report;
    /// CSV: the 0-based data row of each object; otherwise empty.
    std::vector<std::uint32_t> rows{};
    /// Whether the file defines a page. Otherwise (CSV) the page is the extent of the drawing, and
    /// lengths with a unit count from the user origin, as bare numbers do.
    bool paged = true;
    /// For a file without a page: the rectangle around the page and everything drawn, which is
    /// clipped unless another area is given.
    std::optional<clipping::Window> drawn{};
    /// The clip paths as they cut where they are used first; and some that are not used.
    std::vector<NamedArea> clipPaths{};
};

/// What a person says about a file that may not say it itself.
struct ReadOptions {
    std::optional<Unit> unit{};                      ///< of its coordinates; one that has a size
    Projection projection = Projection::PlateCarree; ///< of its degrees
    bool keepsClipPaths = false; ///< SVG: as Particulars::clips, instead of cutting at them
};

/// Versions of DXF that are written: with curves, true colours and line weights, or for old
/// programs and machines.
enum class DxfVersion : std::uint8_t { R2000, R12 };

struct WriteOptions {
    int precision = -1; ///< decimals; -1: the shortest text that reads back bit for bit
    double dpi = 96;    ///< PNG only
    /// Painted on the whole page, behind the drawing. Empty: that of the page if it is exported,
    /// else what is usual, which is white in a picture and nothing elsewhere. With alpha 0 a
    /// picture is transparent.
    std::optional<Colour> background{};
    std::optional<Colour> backgroundOf(const Page& page) const
    {
        return background ? background : page.exportedBackground();
    }
    double tolerance = 0; ///< user units; flattening where the format has no curves; 0: usual
    /// With a limited precision, numbers are rounded and then moved inward, so that the written
    /// decimals lie in this rectangle.
    std::optional<clipping::Window> bounds{};
    /// CSV: the column `source`, one number for each object; rows are sorted by it. Empty: no such
    /// column, and rows in drawing order.
    std::vector<std::uint32_t> sources{};
    DxfVersion dxf = DxfVersion::R2000;              ///< DXF only
    Projection projection = Projection::PlateCarree; ///< GeoJSON: in which degrees were drawn
    bool plain = false; ///< SVG: nothing but SVG, so that texts, shapes and layers are only drawn
    /// DXF: the page of the whole drawing, if that of the document is only a part.
    std::optional<clipping::Window> wholePage{};
    bool paged = true; ///< Imported::paged; otherwise DXF keeps numbers of pixels, without a unit
    /// A stop request before the end leaves the disk unchanged.
    std::stop_token stop{};
};

/// How a format represents a drawing: as paths with curves, as such paths without fills, as
/// polygons and lines without curves, or as separate lines. With separate lines, a line that
/// touches the clip window in a single point counts as kept.
enum class Holds : std::uint8_t { Paths, Outlines, Polygons, SeparateLines };

/// Whether the format can store hidden objects as hidden.
enum class StoresHidden : std::uint8_t { No, Yes };

/// Which members of ReadOptions and WriteOptions a format takes, and whether its files have a page
/// of their own.
struct FormatTakes {
    bool dpi = false;
    bool background = false;
    bool precision = false;
    bool paper = false;
    bool dxf = false;   ///< WriteOptions::dxf
    bool plain = false; ///< WriteOptions::plain
    bool unit = false;  ///< ReadOptions::unit
    bool projection = false;
    bool clipPaths = false; ///< ReadOptions::keepsClipPaths
};

/// One row of the catalogue of file formats. A null function: not supported.
struct Format {
    std::string_view key; ///< "svg": the file name extension, and the value of --from and --to
    QString name;         ///< "SVG drawing", translated; begins with the format's own name
    Result<Imported> (*read)(QIODevice& in);
    /// Returns nothing, or a sentence that says what went wrong. Hidden objects and layers are left
    /// out unless `hides` is Yes.
    std::optional<QString> (*write)(const Document& document, QIODevice& out,
                                    const WriteOptions& options);
    Holds holds = Holds::Paths;
    StoresHidden hides = StoresHidden::No;
    QString limits{};  ///< the largest content of a file, worded to follow "at most "; may be empty
    QString purpose{}; ///< what its files are for, in two words: "edit again"
    FormatTakes takes{};
    /// Reads with options; null: the format takes none.
    Result<Imported> (*readWith)(QIODevice& in, const ReadOptions& options) = nullptr;
    QString shortName() const { return name.section(u' ', 0, 0); } ///< "SVG"
};

/// All formats, in menu order; the first one is the native format.
std::span<const Format> formats();
const Format* findFormat(QStringView key);
/// By the file name extension, in any case. A compressed SVG drawing (.svgz) is an SVG drawing.
const Format* formatOfFile(const QString& path);

/// Opens and reads a file in the given format, or else in the format of its extension. The error
/// sentence names the file. Refuses directories and unknown extensions.
Result<Imported> readFile(const QString& path, const Format* format = nullptr,
                          const ReadOptions& options = {});

/// Writes a file in the given format, or else in the format of its extension; SVG is compressed for
/// the extension .svgz. An existing file is
/// replaced only by a complete new file (QSaveFile); devices and pipes are written to directly.
std::optional<QString> writeFile(const Document& document, const QString& path,
                                 const WriteOptions& options = {}, const Format* format = nullptr);

} // namespace app
