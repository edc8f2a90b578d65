// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/export_cut.h"

#include "app/document/flattened.h"
#include "app/document/hidden_objects.h"
#include "app/formats/format.h"
#include "ui/files/files.h"

#include <new>

namespace ui {

namespace {

constexpr double exportDpi = 300; // of exported pictures

} // namespace

// Separate lines are cut as lines, so that each of them is inside the window.
CutExport exportCut(const app::Document& document, app::CutOptions options, const QString& path,
                    const std::stop_token& stop)
{
    const app::Format* format = app::formatOfFile(path);
    options.keepContacts = format && format->holds == app::Holds::SeparateLines;
    app::WriteOptions writing;
    writing.dpi = exportDpi;
    writing.stop = stop;
    try {
        // A cut adds many styles; the open document keeps its own.
        app::Document exported = app::withOwnStyles(document);
        if (!format || format->hides == app::StoresHidden::No)
            exported = app::withoutHidden(exported);
        if (options.keepContacts)
            exported = app::flattened(exported, app::usualTolerance(exported.page()));
        app::Cut cut = app::cut(exported, options);
        if (stop.stop_requested())
            return {CutExport::End::Stopped};
        cut.edit.windows = app::ClipWindows(); // the exported drawing must not be cut again
        exported.apply(cut.edit);
        if (const auto error = app::writeFile(exported, path, writing))
            return {stop.stop_requested() ? CutExport::End::Stopped : CutExport::End::Failed,
                    *error};
        return {CutExport::End::Written, {}, cut.counts};
    } catch (const std::bad_alloc&) {
        return {CutExport::End::Failed,
                Files::tr("Cannot export %1: there is not enough memory. Close other programs, or "
                          "export a part of the drawing.")
                    .arg(path)};
    }
}

} // namespace ui
