// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheet_export.h"

#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/formats/held.h"

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
    sheets.options.keepContacts = format->holds == Holds::SeparateLines;
    const double tolerance = usualTolerance(sheets.drawing.page());
    sheets.drawing = asHeld(std::move(sheets.drawing), *format, tolerance);
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
