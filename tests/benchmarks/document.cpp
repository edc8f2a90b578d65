// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what a document, its scene and its history take, in bytes and in
// milliseconds of processor time: document [loose|polylines] [SEGMENTS]
#include <QCoreApplication>

#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/measured_document.h"
#include "tests/benchmarks/used_memory.h"

namespace {

constexpr int rounds = 21;
constexpr std::size_t oftenEdited = 100; ///< objects in an edit of several

class Benchmark {
public:
    Benchmark(Drawn drawn, std::size_t segments) : start_(allocatedBytes())
    {
        table_.print("make the document", processorTime([&] {
                         document_ = std::make_unique<MeasuredDocument>(drawn, segments);
                     }),
                     "ms");
        segments_ = double(segments);
        printBytes("document");
        table_.print("make the scene", processorTime([&] { document_->makeScene(); }), "ms");
        printBytes("document and scene");
    }

    void frames()
    {
        document_->clip();
        printBytes("document and scene, clipped");
        table_.print("clip", Figures::of(rounds, [&](int) { document_->clip(); }));
        const app::SceneFrame frame = document_->clip();
        app::Picture picture;
        table_.print("make a picture with ghosts", Figures::of(5, [&](int) {
                         picture = {};
                         picture = document_->picture(frame);
                     }));
        printBytes("all these and the picture");
        table_.print("most memory until then", peakMegabytes(), "MB");
    }

    void hovers()
    {
        const std::size_t before = allocatedBytes();
        document_->makePicking();
        table_.print("first hover", processorTime([&] { document_->hover({640, 400}); }), "ms");
        table_.print("picking", double(allocatedBytes() - before) / segments_, "bytes a segment");
        table_.print("hover", Figures::of(rounds, [&](int i) { hover(i); }));
        const auto first = document_->neighbours(0, 1);
        table_.print("edit 1 object and hover", Figures::of(5, [&](int i) {
                         document_->move(first);
                         hover(i);
                     }));
        document_->forgetHistory();
    }

    void smallEdits()
    {
        const std::size_t last = document_->objects() - 1;
        for (const auto& [where, first] :
             {std::pair("bottom", std::size_t(0)), {"middle", last / 2}, {"top", last}}) {
            const auto name = [&, where = where](const char* what) {
                return std::string(what) + " 1 object, " + where;
            };
            const auto one = document_->neighbours(first, 1);
            edit(name("move"), [&](int) { document_->move(one); });
            edit(name("remove"), [&](int) { document_->remove(one); });
        }
        edit("move 100 neighbours",
             [&](int) { document_->move(document_->neighbours(last / 2, oftenEdited)); });
        edit(
            "move 100 scattered",
            [&](int i) { document_->move(document_->scattered(oftenEdited, unsigned(i))); }, 5);
    }

    /// What 1,000 edits add to the memory; from fewer where they would take too much of it.
    void history()
    {
        const auto kept = [&](const char* what, auto edit) {
            constexpr int edits = 1000;
            constexpr std::size_t enough = 500'000'000;
            const std::size_t before = allocatedBytes();
            int done = 0;
            for (; done < edits && allocatedBytes() - before < enough; ++done)
                edit(done);
            const double each = (double(allocatedBytes()) - double(before)) / done;
            table_.print(what, each * edits * 1e-6, "MB");
            document_->forgetHistory();
        };
        const auto some = [&](int i) {
            const auto room = document_->objects() - oftenEdited;
            return document_->neighbours(std::size_t(i) * 997 * oftenEdited % room, oftenEdited);
        };
        const auto any = [&](int i) { return document_->scattered(oftenEdited, unsigned(i)); };
        const auto width = [](int i) { return 1 + i % 7 * 0.5; };
        kept("1,000 moves of 100 neighbours", [&](int i) { document_->move(some(i)); });
        kept("1,000 moves of 100 scattered", [&](int i) { document_->move(any(i)); });
        kept("1,000 resizes of 100 neighbours", [&](int i) { document_->resize(some(i)); });
        kept("1,000 widths of 100 neighbours",
             [&](int i) { document_->restyle(some(i), width(i)); });
        kept("1,000 widths of 100 scattered", [&](int i) { document_->restyle(any(i), width(i)); });
    }

    void editsOfAll()
    {
        MeasuredDocument::Selection all;
        std::size_t before = allocatedBytes();
        table_.print("select all", processorTime([&] { all = document_->everything(); }), "ms");
        printMegabytes("everything selected", before);
        table_.print("box of everything selected", processorTime([&] { document_->findBox(all); }),
                     "ms");
        before = allocatedBytes();
        table_.print("move everything", processorTime([&] { document_->move(all); }), "ms");
        printMegabytes("a step that moved everything", before);
        table_.print("undo that", processorTime([&] { document_->undo(); }), "ms");
        document_->forgetHistory();
        before = allocatedBytes();
        decltype(document_->snapshot()) snapshot{};
        table_.print("snapshot", processorTime([&] { snapshot = document_->snapshot(); }), "ms");
        printMegabytes("a snapshot", before);
    }

    void peak() { table_.print("most memory of the process", peakMegabytes(), "MB"); }

private:
    // The document is the same afterwards; the steps back are timed as edits of their own.
    template <class Act>
    void edit(const std::string& what, Act act, int times = rounds)
    {
        Figures there, back;
        for (int i = 0; i < times; ++i) {
            there.times.push_back(processorTime([&] { act(i); }));
            back.times.push_back(processorTime([&] { document_->undo(); }));
        }
        table_.print(what.c_str(), there);
        table_.print((what + ", undone").c_str(), back);
        document_->forgetHistory();
    }
    void hover(int i) { document_->hover({200 + 7 * i, 300 + 3 * i}); }
    void printBytes(const char* what)
    {
        table_.print(what, double(allocatedBytes() - start_) / segments_, "bytes a segment");
    }
    void printMegabytes(const char* what, std::size_t before)
    {
        table_.print(what, (double(allocatedBytes()) - double(before)) * 1e-6, "MB");
    }

    FigureTable table_;
    std::size_t start_;
    std::unique_ptr<MeasuredDocument> document_;
    double segments_ = 0;
};

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const auto arguments = QCoreApplication::arguments();
    const Drawn drawn = arguments.value(1) == "polylines" ? Drawn::Polylines : Drawn::Loose;
    const std::size_t segments = arguments.value(2).toULongLong();
    Benchmark benchmark(drawn, segments > 0 ? segments : 1'000'000);
    benchmark.frames();
    benchmark.hovers();
    benchmark.smallEdits();
    benchmark.history();
    benchmark.editsOfAll();
    benchmark.peak();
}
