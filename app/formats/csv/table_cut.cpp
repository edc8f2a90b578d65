// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/table_cut.h"

#include "app/formats/csv/columns.h"

namespace app::csv {
namespace {

using Give = std::function<bool(std::string_view)>;

class CutWork final : public BlockWork {
public:
    CutWork(const CutRows& options, const Give& give, TableCounts& counts)
        : cut_(options), give_(give), counts_(counts)
    {
    }

    void work(const TableRows& rows) override { cut_.cut(rows); }

    bool give() override
    {
        counts_.add(cut_.counts());
        return cut_.text().empty() || give_(cut_.text());
    }

private:
    BlockCut cut_;
    const Give& give_;
    TableCounts& counts_; ///< of all blocks given
};

} // namespace

TableCut cutTable(ByteSource source, const Give& give, const TableCutOptions& options)
{
    TableCut made;
    made.stream = streamTable(
        std::move(source), options.stream,
        [&] { return options.rows.rowsOnly || give(headerText(true)); },
        [&] { return std::make_unique<CutWork>(options.rows, give, made.counts); });
    return made;
}

} // namespace app::csv
