// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/table_cut.h"

#include "app/base/csv_text.h"
#include "app/base/in_turn.h"
#include "app/formats/csv/look_columns.h"

#include <memory>

namespace app::csv {
namespace {

class TableCutter {
public:
    TableCutter(ByteSource source, const std::function<bool(std::string_view)>& give,
                const TableCutOptions& options)
        : blocks_(std::move(source)), give_(give), options_(options)
    {
    }

    TableCut cut()
    {
        readHeader();
        std::vector<TurnSteps> threads;
        for (std::size_t i = 0; i < std::max<std::size_t>(options_.threads, 1); ++i) {
            workers_.push_back(std::make_unique<Worker>(rows_, options_));
            threads.push_back(stepsOf(*workers_.back()));
        }
        result_.complete = options_.rowsOnly || give_(headerText(true));
        if (result_.complete)
            InTurn().run(threads, options_.stopSource);
        result_.report = rows_.report();
        return std::move(result_);
    }

private:
    struct Worker {
        Worker(const RowReader& rows, const TableCutOptions& options) : cut(rows, options) {}
        RecordBlock block;
        BlockCut cut;
        std::optional<Refused> refused;
    };

    void readHeader()
    {
        hasFirst_ = blocks_.first(first_);
        if (!hasFirst_)
            return;
        const RecordBlock::Place& place = first_.places.front();
        RecordFields fields;
        if (!rows_.readHeader(fields.of(first_.text(place)), first_.line + place.line))
            return;
        hasFirst_ = false;
        blocks_.countFromHere();
        if (rows_.beginsWithColour())
            blocks_.endComments();
    }

    TurnSteps stepsOf(Worker& worker)
    {
        return {[this, &worker] { return take(worker.block); },
                [&worker] {
                    worker.refused.reset();
                    try {
                        worker.cut.cut(worker.block);
                    } catch (const Refused& refused) {
                        worker.refused = refused;
                    }
                },
                [this, &worker] { return give(worker); }};
    }

    bool take(RecordBlock& block)
    {
        if (!std::exchange(hasFirst_, false))
            return blocks_.next(block);
        block = std::move(first_);
        return true;
    }

    bool give(const Worker& worker)
    {
        result_.counts.add(worker.cut.counts());
        for (const BadRow& row : worker.cut.badRows())
            if (options_.sayBad && named_++ < mostBadRowsNamed)
                options_.sayBad(row);
        const std::string& text = worker.cut.text();
        result_.complete = text.empty() || give_(text);
        if (worker.refused)
            throw *worker.refused;
        return result_.complete;
    }

    RecordBlocks blocks_;
    const std::function<bool(std::string_view)>& give_;
    const TableCutOptions& options_;
    RowReader rows_;
    RecordBlock first_;
    bool hasFirst_ = false; ///< the first record is a row, and not taken yet
    std::vector<std::unique_ptr<Worker>> workers_;
    TableCut result_;
    std::size_t named_ = 0;
};

} // namespace

TableCut cutTable(ByteSource source, const std::function<bool(std::string_view)>& give,
                  const TableCutOptions& options)
{
    return TableCutter(std::move(source), give, options).cut();
}

} // namespace app::csv
