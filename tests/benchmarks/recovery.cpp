// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what the journal costs while drawing, and a recovery: recovery [LINES]
#include "app/commands/add_and_remove.h"
#include "app/commands/move_objects.h"
#include "app/commands/set_style.h"
#include "app/recovery/journal.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/journal_reading.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/short_lines.h"

namespace {

constexpr int rounds = 15;

/// A drawing whose journal is written. The first and the last receiver of a signal are called
/// before and after the journal.
class Recorded {
public:
    explicit Recorded(int lines) : document_(shortLines(lines))
    {
        QObject::connect(&history_, &app::History::pushed, &context_, [this] { begin(); });
        journal_ = std::make_unique<app::Journal>(document_, history_, home_.path());
        QObject::connect(&history_, &app::History::indexChanged, &context_, [this] { end(); });
        journal_->wait();
    }
    /// The milliseconds that pass while a step is appended, and the processor time.
    void print(FigureTable& table, const QByteArray& what,
               const std::function<app::UndoCommand*(app::EditedDocument&)>& make)
    {
        Figures passed, processor;
        for (int i = 0; i < rounds; ++i) {
            history_.push(make(document_));
            passed.times.push_back(passed_);
            processor.times.push_back(processor_);
            journal_->wait();
            history_.undo();
        }
        table.print(what, passed);
        table.print(what + ", processor", processor);
    }
    /// A new base, and moves until just before the next one, which is the longest replay.
    void fill()
    {
        const int generation = app::logGenerations(folder()).back();
        while (app::logGenerations(folder()).back() == generation)
            moveAll();
        journal_->wait();
        constexpr double ofObject = 0.2e-6; // seconds, as the journal estimates
        const double lines = double(document_.now().objects().size());
        const app::Journal::Limits limits;
        for (int i = int(limits.replay / (ofObject * lines)); i > 0; --i)
            moveAll();
    }
    void moveAll() { history_.push(new app::MoveObjects(document_, all(), {0.1, 0.2})); }
    app::ObjectRanges all() const
    {
        return app::ObjectRanges(app::ObjectRange{0, document_.now().objects().size()});
    }
    QString folder() const { return journal_->folder(); }

private:
    void begin() { start_ = {wall_.nanoseconds(), busy_.nanoseconds()}; }
    void end()
    {
        passed_ = (wall_.nanoseconds() - start_.first) * 1e-6;
        processor_ = (busy_.nanoseconds() - start_.second) * 1e-6;
    }
    QTemporaryDir home_;
    app::Clock wall_ = app::wallClock(), busy_ = app::processorClock();
    std::pair<double, double> start_;
    double passed_ = 0, processor_ = 0;
    QObject context_;
    app::EditedDocument document_;
    app::History history_;
    std::unique_ptr<app::Journal> journal_;
};

void measure(int lines)
{
    FigureTable table;
    table.print("lines", lines, "");
    Recorded drawing(lines);
    const auto every = [&](app::EditedDocument& document) -> app::UndoCommand* {
        return new app::MoveObjects(document, drawing.all(), {0.1, 0.2});
    };
    drawing.print(table, "append a move of all lines", every);
    drawing.print(table, "append a line", [](app::EditedDocument& document) {
        app::Objects line = document.now().objects().slice(0, 0);
        line.append(app::Object{app::Path({{0, 0}, {1, 1}}), {}});
        return new app::AddObjects(document, line, document.now().containers().childrenOf(0)[0],
                                   "Add");
    });
    drawing.print(table, "append a paste of 100,000 lines", [](app::EditedDocument& document) {
        return new app::AddObjects(document, document.now().objects().slice(0, 100'000),
                                   document.now().containers().childrenOf(0)[0], "Paste");
    });
    drawing.fill();
    Figures passed, processor;
    for (int i = 0; i < 5; ++i) {
        double busy = 0;
        passed.times.push_back(elapsedTime([&] {
            busy = processorTime([&] {
                if (!app::replayed(drawing.folder()))
                    qFatal("nothing was recovered");
            });
        }));
        processor.times.push_back(busy);
    }
    table.print("recover: load the base, replay", passed);
    table.print("recover: load the base, replay, processor", processor);
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    if (argc > 1)
        return measure(QString::fromLocal8Bit(argv[1]).toInt()), 0;
    for (const int lines : {100'000, 1'000'000})
        measure(lines);
}
