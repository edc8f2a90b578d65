// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/export_cut.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/document/flattened.h"
#include "app/document/hidden_objects.h"
#include "app/formats/format.h"

namespace app {

namespace {

constexpr double exportDpi = 300;                      // of exported pictures
constexpr double cuttingWeight = 4, writingWeight = 1; // for the progress

// Separate lines are cut as lines, so that each of them is inside the window.
std::optional<QString> cutAndWrite(const Document& document, CutOptions options,
                                   const QString& path, const Follower& follower, CutCounts& counts)
{
    const Format* format = formatOfFile(path);
    options.keepContacts = format && format->holds == Holds::SeparateLines;
    WriteOptions writing;
    writing.dpi = exportDpi;
    writing.stop = follower.stop;
    // A cut adds many styles; the open document keeps its own.
    Document exported = withOwnStyles(document);
    if (!format || format->hides == StoresHidden::No)
        exported = withoutHidden(exported);
    if (options.keepContacts)
        exported = flattened(exported, usualTolerance(exported.page()));
    PhasedProgress phases(follower, {cuttingWeight, writingWeight});
    Cut result = cut(exported, options, phases.next());
    counts = result.counts;
    if (follower.stop.stop_requested())
        return QString();
    result.edit.windows = ClipWindows(); // the exported drawing must not be cut again
    Page page = result.edit.page.value_or(exported.page());
    page.guides = {}; // they are not part of what is drawn
    page.sheets.reset();
    result.edit.page = std::move(page);
    exported.apply(result.edit);
    return writeFile(exported, path, writing);
}

} // namespace

CutExport exportCut(const Document& document, const CutOptions& options, const QString& path,
                    const Follower& follower)
{
    CutCounts counts;
    const auto write = [&] { return cutAndWrite(document, options, path, follower, counts); };
    const QString outOfMemory =
        Text::tr(
            "Cannot export %1: there is not enough memory. Close other programs, or export a part "
            "of the drawing.")
            .arg(path);
    return {resultOf(write, follower.stop, outOfMemory), counts};
}

} // namespace app
