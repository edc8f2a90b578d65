// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <array>
#include <new>

namespace app {

// Each is defined in the file of its format.
Format svgFormat();
Format csvFormat();
Format pdfFormat();
Format pngFormat();

// THE CATALOGUE. To add a format: write its file here, in app/formats/, and name it in both lists.
std::span<const Format> formats()
{
    static const std::array all{svgFormat(), csvFormat(), pdfFormat(), pngFormat()};
    return all;
}

const Format* findFormat(QStringView key)
{
    const auto found = std::ranges::find_if(formats(), [&](const Format& format) {
        return key.compare(QLatin1StringView(format.key), Qt::CaseInsensitive) == 0;
    });
    return found == formats().end() ? nullptr : &*found;
}

const Format* formatOfFile(const QString& path) { return findFormat(QFileInfo(path).suffix()); }

bool Imported::lossy() const
{
    return std::ranges::any_of(report, [](const Loss& loss) { return !loss.remark; });
}

Result<Imported> readFile(const QString& path, const Format* format)
{
    const auto failure = [&](const QString& why) {
        return Result<Imported>::failure(
            QCoreApplication::translate("formats", "Cannot open %1: %2").arg(path, why));
    };
    const QFileInfo info(path);
    if (info.isDir())
        return failure(
            QCoreApplication::translate("formats", "it is a folder. Name a file in it."));
    if (!info.exists())
        return failure(QCoreApplication::translate("formats", "there is no such file."));
    format = format ? format : formatOfFile(path);
    if (!format || !format->read)
        return failure(
            QCoreApplication::translate("formats", "this type of file is not read here."));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(file.errorString() + u'.');
    try {
        Result<Imported> result = format->read(file);
        return result ? std::move(result) : failure(result.error);
    } catch (const std::bad_alloc&) {
        return failure(QCoreApplication::translate(
            "formats", "there is not enough memory for it. Close other programs, or split it."));
    }
}

namespace {

// What went wrong, if anything, with `file` written and `finish`ed.
std::optional<QString> writeTo(QFileDevice& file, const Sheet& sheet, const WriteOptions& options,
                               const Format& format, bool (*finish)(QFileDevice&))
{
    if (!file.open(QIODevice::WriteOnly))
        return file.errorString() + u'.';
    if (auto error = format.write(sheet, file, options))
        return error;
    if (options.stop.stop_requested())
        return QCoreApplication::translate("formats", "it was cancelled.");
    return finish(file) ? std::nullopt : std::optional(file.errorString() + u'.');
}

} // namespace

std::optional<QString> writeFile(const Sheet& sheet, const QString& path,
                                 const WriteOptions& options, const Format* format)
{
    const auto failure = [&](const QString& why) {
        return QCoreApplication::translate("formats", "Cannot write %1: %2").arg(path, why);
    };
    format = format ? format : formatOfFile(path);
    if (!format || !format->write)
        return failure(
            QCoreApplication::translate("formats", "this type of file is not written here."));
    const QFileInfo info(path);
    std::optional<QString> error;
    if (info.exists() && !info.isFile() && !info.isDir()) { // never replace a device by a file
        QFile device(path);
        error = writeTo(device, sheet, options, *format, [](QFileDevice& f) { return f.flush(); });
    } else {
        QSaveFile file(path);
        error = writeTo(file, sheet, options, *format,
                        [](QFileDevice& f) { return static_cast<QSaveFile&>(f).commit(); });
    }
    return error ? std::optional(failure(*error)) : std::nullopt;
}

} // namespace app
