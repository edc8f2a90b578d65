// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/difference_output.h"

#include "app/base/write_all.h"
#include "app/command_line/drawing_files.h"

namespace app {
namespace {

/// The facts about all lines in one row, without the lines that differ.
Table summed(Table table)
{
    table.names.clear();
    table.rows = {{}};
    for (const auto& [name, value] : table.facts) {
        table.names << name;
        table.rows.front() << value;
    }
    table.facts.clear();
    return table;
}

} // namespace

DifferenceOutput::DifferenceOutput(const ComparedAt& at, const TableOutput& output,
                                   bool onlySummary)
    : at_(at), output_(output), onlySummary_(onlySummary)
{
}

DifferenceRows::Form DifferenceOutput::form() const
{
    using Form = DifferenceRows::Form;
    return onlySummary_ ? Form::None : output_.format.key == u"csv" ? Form::Csv : Form::Fields;
}

void DifferenceOutput::write(const std::function<void()>& find)
{
    if (csvRows())
        return writeWith(
            [&](QIODevice& out) -> std::optional<QString> {
                out_ = &out;
                find();
                return std::nullopt;
            },
            output_.path.isEmpty() ? QStringLiteral("-") : output_.path);
    find();
    writeTable();
}

bool DifferenceOutput::begin() { return !csvRows() || writeAll(*out_, differenceHeader()); }

bool DifferenceOutput::give(const DifferenceRows& rows)
{
    totals_.add(rows.totals());
    if (csvRows())
        return rows.csv().empty() || writeAll(*out_, rows.csv());
    rows_.insert(rows_.end(), rows.fields().begin(), rows.fields().end());
    return true;
}

QString DifferenceOutput::summary() const
{
    const Comparison& comparison = at_.comparison;
    return sentence(comparison.a, comparison.b, totals_.counts, totals_.lines) + u'.';
}

// In text format, a summary or a comparison without differences prints only the sentence.
void DifferenceOutput::writeTable() const
{
    if (output_.format.key == u"text" && (onlySummary_ || rows_.empty()))
        return;
    Table table{.names = differenceNames(),
                .rows = rows_,
                .title = summary(),
                .key = QStringLiteral("differences"),
                .facts = factsOf(at_)};
    table.facts.emplace_back("lines", QString::number(totals_.lines));
    table.facts.emplace_back("differing", QString::number(totals_.counts.all()));
    if (onlySummary_)
        table = summed(std::move(table));
    writeTables(output_, {&table, 1});
}

} // namespace app
