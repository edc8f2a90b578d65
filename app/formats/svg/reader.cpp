// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/reader.h"

#include "app/base/text.h"
#include "app/document/contents.h"
#include "app/formats/gzip.h"
#include "app/formats/painted.h"
#include "app/formats/svg/guide_text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/page.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scale_text.h"
#include "app/formats/svg/sheets_text.h"
#include "app/formats/svg/tree_drawer.h"
#include "app/formats/svg/window_text.h"
#include "app/formats/whole_pipe.h"

#include <QBuffer>
#include <QFileDevice>
#include <QFileInfo>

#include <glm/common.hpp>

namespace app::svg {
namespace {

// For a file without a page: the rectangle around the page and everything drawn.
std::optional<clipping::Window> drawnOf(const RootPage& root, const Document& document)
{
    if (document.objects().empty() || !(root.openX || root.openY))
        return std::nullopt;
    const clipping::Window page = document.page().rectangle();
    const clipping::Window drawn = pageAround(document.objects()).rectangle();
    return clipping::Window{glm::min(page.min, drawn.min), glm::max(page.max, drawn.max)};
}

/// Where the text of a drawing comes from, and how it is read.
struct Source {
    QString folder;
    const ReadOptions& options;
};

void draw(const Tree& tree, const RootPage& root, Styles& styles, Report& report,
          const Source& source, Imported& imported)
{
    TreeDrawer drawer(tree, styles, report, root.page, ImageSource(source.folder));
    drawer.keepClipPaths(source.options.keepsClipPaths);
    try {
        imported.document = drawer.drawAll(root.matrix, root.viewport);
        imported.clipPaths = drawer.takeClipPaths();
    } catch (Refused& refused) {
        if (refused.line == Refused::here)
            refused.line = drawer.line();
        throw;
    }
}

void refuseUnusable(const Page& page)
{
    if (const auto fault = faultOf(page))
        throw Refused{*fault, Refused::wholeFile};
}

Imported import(const Tree& tree, Report& report, const Source& source)
{
    Imported imported;
    Styles styles(tree, report);
    const RootPage root = readPage(tree, styles, report);
    refuseUnusable(root.page);
    draw(tree, root, styles, report, source, imported);
    Document& document = imported.document;
    Page page = closed(root, document.objects());
    refuseUnusable(page);
    page.guides = readGuides(tree, report);
    page.sheets = readSheets(tree, report);
    readScale(tree, page, report);
    document.apply({.windows = readWindows(tree, report), .page = std::move(page)});
    imported.drawn = drawnOf(root, document);
    imported.report = report.losses();
    return imported;
}

QByteArray pipeOf(QIODevice& in)
{
    auto data = wholePipe(in, mostBytes);
    return data ? std::move(*data.value) : throw Refused{data.error, Refused::wholeFile};
}

Tree readTree(QIODevice& in, Report& report)
{
    if (!in.isSequential())
        return Tree::read(in, report);
    QByteArray data = pipeOf(in);
    QBuffer buffer(&data);
    buffer.open(QIODevice::ReadOnly);
    return Tree::read(buffer, report);
}

Tree readZippedTree(QIODevice& in, Report& report)
{
    std::optional<QByteArray> data;
    if (in.isSequential()) {
        QByteArray pipe = pipeOf(in);
        QBuffer buffer(&pipe);
        buffer.open(QIODevice::ReadOnly);
        data = unzipped(buffer, mostBytes);
    } else {
        data = unzipped(in, mostBytes);
    }
    if (!data)
        throw Refused{Text::tr("it is compressed (.svgz) and damaged, incomplete or larger than "
                               "%1 bytes.")
                          .arg(mostBytes),
                      Refused::wholeFile};
    QBuffer buffer(&*data);
    buffer.open(QIODevice::ReadOnly);
    return Tree::read(buffer, report);
}

/// The folder of a file; empty for anything else.
QString folderOf(QIODevice& in)
{
    const auto* const file = qobject_cast<QFileDevice*>(&in);
    return file && !file->fileName().isEmpty() && !file->isSequential()
               ? QFileInfo(file->fileName()).absolutePath()
               : QString();
}

} // namespace

Result<Imported> read(QIODevice& in) { return read(in, {}); }

Result<Imported> read(QIODevice& in, const ReadOptions& options)
{
    try {
        Report report;
        const Tree tree = isZipped(in) ? readZippedTree(in, report) : readTree(in, report);
        return Result<Imported>::of(import(tree, report, {folderOf(in), options}));
    } catch (const Refused& refused) {
        return Result<Imported>::failure(
            refused.line > 0 ? Text::tr("line %1 %2").arg(refused.line).arg(refused.why)
                             : refused.why);
    }
}

} // namespace app::svg
