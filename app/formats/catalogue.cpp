// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/file_kind.h"
#include "app/formats/format.h"
#include "app/formats/gzip.h"
#include "app/formats/read_open_file.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <new>

namespace app {

// Each function is defined in the file of its format.
Format svgFormat();
Format csvFormat();
Format pdfFormat();
Format pngFormat();
Format dxfFormat();
Format geojsonFormat();

// THE CATALOGUE. To add a format, write its file in app/formats/, declare its function above, and
// add it to the list below.
std::span<const Format> formats()
{
    // clang-format off
    static const std::array all{
        svgFormat(),
        csvFormat(),
        pdfFormat(),
        pngFormat(),
        dxfFormat(),
        geojsonFormat(),
    };
    // clang-format on
    return all;
}

// "svg, csv": the formats that can be read, or written.
template <class Function>
static QString typesWith(Function Format::*can)
{
    QStringList keys;
    for (const Format& format : formats())
        if (format.*can)
            keys << QLatin1StringView(format.key);
    return keys.join(QStringLiteral(", "));
}

const Format* findFormat(QStringView key) { return kindOf(formats(), key); }

static bool isCompressedSvg(const QString& path)
{
    return QFileInfo(path).suffix().compare(QStringLiteral("svgz"), Qt::CaseInsensitive) == 0;
}

const Format* formatOfFile(const QString& path)
{
    return findFormat(isCompressedSvg(path) ? QStringLiteral("svg") : QFileInfo(path).suffix());
}

bool mustSaveAs(const std::vector<Loss>& report)
{
    return std::ranges::any_of(
        report, [](const Loss& loss) { return !loss.remark || loss.cut || loss.outlined; });
}

Result<Imported> readFile(const QString& path, const Format* format, const ReadOptions& options)
{
    const auto failure = [&](const QString& why) {
        return Result<Imported>::failure(Text::tr("Cannot open %1: %2").arg(path, why));
    };
    if (const auto fault = faultToOpen(path))
        return failure(*fault);
    format = format ? format : formatToRead(path);
    if (!format || !format->read)
        return failure(Text::tr("Clearcut does not read this type of file. It reads %1.")
                           .arg(typesWith(&Format::read)));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(file.errorString() + u'.');
    try {
        Result<Imported> result = readOpenFile(file, *format, options);
        return result ? std::move(result) : failure(result.error);
    } catch (const std::bad_alloc&) {
        return failure(
            Text::tr("there is not enough memory. Close other programs, or split the file."));
    }
}

std::optional<QString> writeFile(const Document& document, const QString& path,
                                 const WriteOptions& options, const Format* format)
{
    const auto failure = [&](const QString& why) {
        return Text::tr("Cannot write %1: %2").arg(path, why);
    };
    format = format ? format : formatOfFile(path);
    if (!format || !format->write)
        return failure(Text::tr("Clearcut does not write this type of file. It writes %1.")
                           .arg(typesWith(&Format::write)));
    const bool compresses = isCompressedSvg(path) && format == findFormat(u"svg");
    const auto error = replaceFile(path, [&](QIODevice& out) {
        QBuffer plain;
        plain.open(QIODevice::WriteOnly);
        auto wrong = format->write(document, compresses ? plain : out, options);
        if (!wrong && compresses && out.write(zipped(plain.data())) < 0)
            wrong = out.errorString() + u'.';
        if (!wrong && options.stop.stop_requested())
            wrong = Text::tr("it was cancelled.");
        return wrong;
    });
    return error ? std::optional(failure(*error)) : std::nullopt;
}

} // namespace app
