// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/read_open_file.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/formats/content_kind.h"

#include <QFileInfo>

namespace app {

namespace {

/// Says what a file is that has another kind of content than its name.
Result<Imported> byContent(Result<Imported> failed, QFileDevice& file, const Format& format)
{
    if (file.isSequential() || !file.seek(0))
        return failed;
    const ContentKind kind = contentKind(file.read(contentHead));
    const Format* const own = formatToRead(QStringLiteral("a.") + kind.ending);
    if (kind.name.isEmpty() || (own && own->key == format.key))
        return failed;
    return Result<Imported>::failure(
        kind.ending.isEmpty() ? Text::tr("by its content it is %1.").arg(kind.name)
                              : Text::tr("by its content it is %1. Give it the ending .%2.")
                                    .arg(kind.name, kind.ending));
}

} // namespace

Result<Imported> readOpenFile(QFileDevice& file, const Format& format, const ReadOptions& options)
{
    // A read error is treated as the end of the file. After a part, only the next read says it.
    auto result = format.readWith ? format.readWith(file, options) : format.read(file);
    if (!file.isSequential())
        file.getChar(nullptr);
    if (file.error() == QFileDevice::NoError)
        return result ? std::move(result) : byContent(std::move(result), file, format);
    return Result<Imported>::failure(
        Text::tr("it cannot be read to its end. %1.").arg(file.errorString()));
}

std::optional<QString> faultToOpen(const QString& path)
{
    const QFileInfo info(path);
    if (info.isDir())
        return Text::tr("it is a folder. Name a file in it.");
    if (auto fault = faultOfName(path))
        return fault;
    if (!info.exists())
        return Text::tr("there is no such file.");
    return std::nullopt;
}

const Format* formatToRead(const QString& path)
{
    return QFileInfo(path).suffix().toLower() == u"dwg" ? findFormat(u"dxf") : formatOfFile(path);
}

} // namespace app
