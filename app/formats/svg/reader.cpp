// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/reader.h"

#include "app/document/page_around.h"
#include "app/formats/svg/page.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/walk.h"

namespace app::svg {
namespace {

Imported import(const Tree& tree)
{
    Imported imported;
    Report report;
    Sheet& sheet = imported.sheet;
    const RootPage root = readPage(tree);
    Walk walk(tree, sheet, report, flatteningMillimetres / root.page.millimetresPerUnit());
    try {
        walk.drawAll(root.matrix, root.page.size / Point{1, root.matrix.d});
    } catch (Refused& refused) {
        if (refused.line == Refused::here)
            refused.line = walk.line();
        throw;
    }
    sheet.page = root.unsized ? pageAround(sheet.shapes) : root.page;
    sheet.window = readWindow(tree).value_or(sheet.page.rectangle());
    imported.report = report.losses();
    return imported;
}

} // namespace

Result<Imported> read(QIODevice& in)
{
    if (in.peek(2) == "\x1f\x8b")
        return Result<Imported>::failure(
            Text::tr("it is compressed (.svgz). Unpack it with gunzip and open the .svg file."));
    try {
        return Result<Imported>::of(import(Tree::read(in)));
    } catch (const Refused& refused) {
        return Result<Imported>::failure(
            refused.line > 0 ? Text::tr("line %1 %2").arg(refused.line).arg(refused.why)
                             : refused.why);
    }
}

} // namespace app::svg
