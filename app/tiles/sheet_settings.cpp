// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheet_settings.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/paper.h"

#include <QFileInfo>
#include <QPageSize>
#include <QSizeF>

namespace app {
namespace {

constexpr std::string_view manyPages = "pdf";

} // namespace

TilePlan planOf(const SheetSettings& settings)
{
    TilePlan plan = settings.plan;
    const Point paper = paperSize(settings.paper).value_or(Point(210, 297));
    plan.sheet = settings.byNumber    ? Point(0)
                 : settings.landscape ? Point(paper.y, paper.x)
                                      : paper;
    return plan;
}

QString paperText(const SheetSettings& settings, const Tiling& tiling)
{
    if (settings.byNumber)
        return Text::tr("%1 × %2 mm")
            .arg(numberText(tiling.sheet.x, 0), numberText(tiling.sheet.y, 0));
    return (settings.landscape ? Text::tr("%1 landscape") : Text::tr("%1 portrait"))
        .arg(settings.paper);
}

QString patternOf(const SheetSettings& settings, const QString& title)
{
    QString name =
        settings.name.isEmpty() ? title + QStringLiteral("-{row}-{column}") : settings.name;
    const QString plain = nameWithoutNumbers(name);
    if (settings.oneFile)
        name = plain.isEmpty() ? title : plain;
    else if (name == plain) // it was that of one file
        name += QStringLiteral("-{row}-{column}");
    return name + u'.' + QString::fromStdString(settings.format);
}

Result<SheetSettings> withName(SheetSettings settings, const QString& typed, const Tiling& tiling)
{
    using Refused = Result<SheetSettings>;
    QString name = typed.trimmed();
    if (name.contains(u'/'))
        return Refused::failure(
            Text::tr("A name must not contain “/”. The folder is chosen later."));
    if (const Format* format = formatOfFile(name); format && format->write) {
        name.chop(QFileInfo(name).suffix().size() + 1);
        if (settings.format != format->key)
            settings = withFormat(std::move(settings), *format);
    }
    if (nameWithoutNumbers(name).isEmpty() && (settings.oneFile || name.isEmpty()))
        return Refused::failure(Text::tr("Type a name for the files."));
    if (!settings.oneFile && !namesEverySheet(name, tiling))
        return Refused::failure(Text::tr(
            "Each sheet needs a name of its own: put {row} and {column}, or {n}, into it."));
    settings.name = name;
    return Refused::of(std::move(settings));
}

SheetSettings withFormat(SheetSettings settings, const Format& format)
{
    settings.format = format.key;
    settings.oneFile = settings.oneFile && format.key == manyPages;
    return settings;
}

SheetSettings withOneFile(SheetSettings settings, bool oneFile)
{
    settings.oneFile = oneFile;
    if (oneFile)
        settings.format = manyPages;
    return settings;
}

std::vector<const Format*> sheetFormats()
{
    std::vector<const Format*> writable;
    for (const Format& format : formats())
        if (format.write)
            writable.push_back(&format);
    return writable;
}

QStringList papers()
{
    QStringList names;
    for (const NamedPaper& paper : namedPapers())
        names << latin(paper.name);
    return names;
}

std::optional<Point> paperSize(const QString& name)
{
    for (int id = 0; id <= QPageSize::LastPageSize; ++id) {
        const auto size = QPageSize::PageSizeId(id);
        if (QPageSize::key(size).compare(name, Qt::CaseInsensitive) != 0)
            continue;
        const QSizeF paper = QPageSize::size(size, QPageSize::Millimeter);
        return paper.isEmpty() ? std::nullopt : std::optional(Point(paper.width(), paper.height()));
    }
    return std::nullopt;
}

} // namespace app
