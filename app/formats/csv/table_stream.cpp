// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/table_stream.h"

#include "app/base/csv_text.h"
#include "app/base/in_turn.h"

namespace app::csv {
namespace {

class TableStream {
public:
    TableStream(ByteSource source, const TableStreamOptions& options)
        : blocks_(std::move(source)), options_(options)
    {
    }

    TableStreamed run(const std::function<bool()>& begin,
                      const std::function<std::unique_ptr<BlockWork>()>& newWork)
    {
        readHeader();
        std::vector<TurnSteps> threads;
        for (std::size_t i = 0; i < std::max<std::size_t>(options_.threads, 1); ++i) {
            workers_.push_back(std::make_unique<Worker>(rows_, options_.bad, newWork()));
            threads.push_back(stepsOf(*workers_.back()));
        }
        result_.complete = begin();
        if (result_.complete)
            InTurn().run(threads, options_.stopSource);
        result_.report = rows_.report();
        return std::move(result_);
    }

private:
    struct Worker {
        Worker(const RowReader& reader, BadRows bad, std::unique_ptr<BlockWork> w)
            : rows(reader, bad), work(std::move(w))
        {
        }
        RecordBlock block;
        TableRows rows;
        std::unique_ptr<BlockWork> work;
        std::optional<Refused> refused;
    };

    void readHeader()
    {
        hasFirst_ = blocks_.first(first_);
        if (!hasFirst_)
            return;
        const RecordBlock::Place& place = first_.places.front();
        const std::size_t line = first_.line + place.line;
        const bool isHeader = rows_.readHeader(first_.text(place), line);
        blocks_.setSeparator(rows_.separator());
        if (!isHeader)
            return;
        hasFirst_ = false;
        blocks_.countFromHere();
        if (rows_.beginsWithColour())
            blocks_.endComments();
    }

    TurnSteps stepsOf(Worker& worker)
    {
        return {[this, &worker] { return take(worker.block); }, [&worker] { work(worker); },
                [this, &worker] { return give(worker); }};
    }

    bool take(RecordBlock& block)
    {
        if (!std::exchange(hasFirst_, false))
            return blocks_.next(block);
        block = std::move(first_);
        return true;
    }

    // At a bad row, the rows before it are worked on.
    static void work(Worker& worker)
    {
        worker.refused.reset();
        try {
            worker.rows.read(worker.block);
        } catch (const Refused& refused) {
            worker.refused = refused;
        }
        worker.work->work(worker.rows);
    }

    bool give(const Worker& worker)
    {
        result_.badRows += worker.rows.badCount();
        for (const BadRow& row : worker.rows.badRows())
            if (options_.sayBad && named_++ < mostBadRowsNamed)
                options_.sayBad(row);
        result_.complete = worker.work->give();
        if (worker.refused)
            throw *worker.refused;
        return result_.complete;
    }

    RecordBlocks blocks_;
    const TableStreamOptions& options_;
    RowReader rows_;
    RecordBlock first_;
    bool hasFirst_ = false; ///< the first record is a row, and not taken yet
    std::vector<std::unique_ptr<Worker>> workers_;
    TableStreamed result_;
    std::size_t named_ = 0;
};

} // namespace

TableStreamed streamTable(ByteSource source, const TableStreamOptions& options,
                          const std::function<bool()>& begin,
                          const std::function<std::unique_ptr<BlockWork>()>& newWork)
{
    return TableStream(std::move(source), options).run(begin, newWork);
}

} // namespace app::csv
