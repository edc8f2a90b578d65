// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/reader.h"

#include "app/document/legacy.h"
#include "app/document/page_around.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/page.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/walk.h"

#include <QBuffer>

#include <glm/common.hpp>

namespace app::svg {
namespace {

// The page; of a file without a page, all that is drawn as well.
clipping::Window usualWindow(const RootPage& root, const Sheet& sheet)
{
    const clipping::Window page = sheet.page.rectangle();
    if (sheet.shapes.empty() || !(root.openX || root.openY))
        return page;
    const clipping::Window drawn = pageAround(sheet.shapes).rectangle();
    return {glm::min(page.min, drawn.min), glm::max(page.max, drawn.max)};
}

Imported import(const Tree& tree)
{
    Imported imported;
    Report report;
    Sheet sheet;
    const RootPage root = readPage(tree);
    Walk walk(tree, sheet, report, usualTolerance(root.page));
    try {
        walk.drawAll(root.matrix, root.viewport);
    } catch (Refused& refused) {
        if (refused.line == Refused::here)
            refused.line = walk.line();
        throw;
    }
    sheet.page = closed(root, sheet.shapes);
    const auto saved = readWindow(tree);
    imported.windowSaved = saved.has_value();
    sheet.window = saved.value_or(usualWindow(root, sheet));
    sheet.about = tree.about();
    imported.document = documentOf(sheet);
    imported.report = report.losses();
    return imported;
}

// A token may be as long as what is read, and a pipe may never end.
QByteArray wholePipe(QIODevice& in)
{
    QByteArray data;
    while (in.waitForReadyRead(-1) || !in.atEnd()) {
        const QByteArray more = in.read(qint64(1) << 20);
        if (more.isEmpty())
            break;
        data += more;
        if (std::size_t(data.size()) > mostBytes)
            throw Refused{
                Text::tr("it is larger than %1 bytes. Save it as a file first.").arg(mostBytes),
                Refused::wholeFile};
    }
    return data;
}

Tree readTree(QIODevice& in)
{
    if (!in.isSequential())
        return Tree::read(in);
    QByteArray data = wholePipe(in);
    QBuffer buffer(&data);
    buffer.open(QIODevice::ReadOnly);
    return Tree::read(buffer);
}

} // namespace

Result<Imported> read(QIODevice& in)
{
    if (in.peek(2) == "\x1f\x8b")
        return Result<Imported>::failure(
            Text::tr("it is compressed (.svgz). Unpack it with gunzip and open the .svg file."));
    try {
        return Result<Imported>::of(import(readTree(in)));
    } catch (const Refused& refused) {
        return Result<Imported>::failure(
            refused.line > 0 ? Text::tr("line %1 %2").arg(refused.line).arg(refused.why)
                             : refused.why);
    }
}

} // namespace app::svg
