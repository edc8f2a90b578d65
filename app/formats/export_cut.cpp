// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/export_cut.h"

#include "app/document/flattened.h"
#include "app/document/hidden_objects.h"
#include "app/formats/format.h"

#include <QCoreApplication>

#include <new>

namespace app {

namespace {

constexpr double exportDpi = 300; // of exported pictures

QString tr(const char* text) { return QCoreApplication::translate("Export", text); }

} // namespace

// Separate lines are cut as lines, so that each of them is inside the window.
CutExport exportCut(const Document& document, CutOptions options, const QString& path,
                    const std::stop_token& stop)
{
    const Format* format = formatOfFile(path);
    options.keepContacts = format && format->holds == Holds::SeparateLines;
    WriteOptions writing;
    writing.dpi = exportDpi;
    writing.stop = stop;
    try {
        // A cut adds many styles; the open document keeps its own.
        Document exported = withOwnStyles(document);
        if (!format || format->hides == StoresHidden::No)
            exported = withoutHidden(exported);
        if (options.keepContacts)
            exported = flattened(exported, usualTolerance(exported.page()));
        Cut result = cut(exported, options);
        if (stop.stop_requested())
            return {CutExport::End::Stopped};
        result.edit.windows = ClipWindows(); // the exported drawing must not be cut again
        exported.apply(result.edit);
        if (const auto error = writeFile(exported, path, writing))
            return {stop.stop_requested() ? CutExport::End::Stopped : CutExport::End::Failed,
                    *error};
        return {CutExport::End::Written, {}, result.counts};
    } catch (const std::bad_alloc&) {
        return {CutExport::End::Failed,
                tr("Cannot export %1: there is not enough memory. Close other programs, or "
                   "export a part of the drawing.")
                    .arg(path)};
    }
}

} // namespace app
