// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/open_file.h"

#include "app/base/memory.h"
#include "app/base/text.h"

#include <new>

namespace app {
namespace {

constexpr std::uint64_t bytesOfLine = 100; // its segment, its pieces and its strokes

Result<Imported> refused(const QString& path, const QString& why)
{
    return Result<Imported>::failure(Text::tr("Cannot open %1: %2").arg(path, why));
}

} // namespace

OpenedFile openFile(const QString& path)
{
    OpenedFile opened{readFile(path)};
    if (!opened.drawing)
        return opened;
    try {
        const Document& document = opened.drawing.value->document;
        const QString fault = memoryFault(document.objects().size() * bytesOfLine);
        if (!fault.isEmpty())
            return {refused(path, fault)};
        opened.blocks = blocksFor(document);
    } catch (const std::bad_alloc&) {
        return {refused(
            path,
            Text::tr("there is not enough memory. Close other programs, or split the file."))};
    }
    return opened;
}

} // namespace app
