// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table_input.h"

#include "app/base/csv_text.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/document/document_builder.h"

#include <QThread>

namespace app {
namespace {

constexpr std::size_t mostThreads = 12; // each needs up to 3.5 MB, and all together at most 100 MB
constexpr std::size_t bytesForAThread = 1 << 18;

std::size_t threadsFor(const InputBytes& in)
{
    // One more than cores: one of them waits for bytes, or for its turn to write.
    const auto threads = std::min(std::size_t(QThread::idealThreadCount()) + 1, mostThreads);
    return in.size() ? std::min(threads, *in.size() / bytesForAThread + 1) : threads;
}

void sayBad(const csv::BadRow& row)
{
    say(Text::tr("Skipped: line %1 %2").arg(row.line).arg(row.why));
}

} // namespace

Option skipBadOption(const QString& meaning) { return {{"skip-bad"}, {}, meaning}; }

Imported tableWithoutLines()
{
    Imported table;
    table.paged = false;
    DocumentBuilder builder;
    Page page;
    page.width = {page.size.x, Unit::Px};
    page.height = {page.size.y, Unit::Px};
    table.document = builder.take(page);
    return table;
}

csv::TableStreamed streamed(InputBytes& in, const ParsedArguments& arguments,
                            const StreamsTable& stream)
{
    csv::TableStreamOptions options{.threads = threadsFor(in)};
    if (arguments.has(QStringLiteral("skip-bad")))
        options.bad = csv::BadRows::Skip;
    if (!arguments.has(QStringLiteral("quiet")))
        options.sayBad = sayBad;
    options.stopSource = [&] { in.stop(); };
    try {
        return stream([&](char* bytes, std::size_t size) { return in.read(bytes, size); }, options);
    } catch (const csv::Refused& refused) {
        in.fail(Text::tr("line %1 %2").arg(refused.line).arg(refused.why));
    }
}

void sayBadRows(const csv::TableStreamed& streamed)
{
    if (streamed.badRows > 0)
        say(Text::tr("Bad rows skipped: %1.").arg(streamed.badRows));
}

} // namespace app
