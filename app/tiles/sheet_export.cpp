// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheet_export.h"

#include "app/base/text.h"
#include "app/document/flattened.h"
#include "app/document/hidden_objects.h"

namespace app {
namespace {

constexpr double exportDpi = 300; // of exported pictures

std::optional<QString> write(Sheets& sheets, const QString& pattern, const Follower& follower)
{
    const Format* format = formatOfFile(pattern);
    if (!format || !format->write)
        return Text::tr("Sheets cannot be written as %1.").arg(pattern);
    if (format->hides == StoresHidden::No)
        sheets.drawing = withoutHidden(std::move(sheets.drawing));
    if (format->holds == Holds::SeparateLines) { // cut as lines, so that each is on its sheet
        sheets.options.keepContacts = true;
        sheets.drawing =
            flattened(std::move(sheets.drawing), usualTolerance(sheets.drawing.page()));
    }
    WriteOptions options;
    options.dpi = exportDpi;
    return writeSheets(sheets, pattern, *format, options, follower);
}

} // namespace

WriteResult exportSheets(Sheets sheets, const QString& pattern, const Follower& follower)
{
    const QString outOfMemory = Text::tr("Cannot export the sheets: there is not enough "
                                         "memory. Close other programs, and try again.");
    return resultOf([&] { return write(sheets, pattern, follower); }, follower.stop, outOfMemory);
}

} // namespace app
