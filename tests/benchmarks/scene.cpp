// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the scene of blocks beside one array of all lines, on the same lines and in turns:
// scene [loose|polylines] [SEGMENTS]
#include "clipping/chunks.h"
#include "clipping/outside.h"

#include <QCoreApplication>

#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "tests/app/scene/block_scene.h"
#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/timing.h"
#include "tests/benchmarks/used_memory.h"

namespace {

constexpr int rounds = 21;
constexpr double tolerance = 0.1;
const app::Point pageSize(1280, 800);

/// Lines that touch nothing, or pen lines of so many segments.
class RandomPaths {
public:
    explicit RandomPaths(std::size_t segments) : segments_(segments) {}

    app::Subpath next()
    {
        app::Subpath path{{x_(random_), y_(random_)}, {}, false};
        app::Point at = path.start;
        for (std::size_t i = 0; i < segments_; ++i) {
            const double l = length_(random_), t = angle_(random_);
            path.segments.push_back({at += l * app::Point(std::cos(t), std::sin(t))});
        }
        return path;
    }

private:
    std::size_t segments_;
    std::mt19937_64 random_{1};
    std::uniform_real_distribution<double> x_{0, 1280}, y_{0, 800}, length_{3, 17},
        angle_{0, 2 * M_PI};
};

app::Objects someObjects(std::size_t count, std::size_t each)
{
    RandomPaths paths(each);
    app::Objects objects;
    app::Style style;
    style.stroke = app::Colour{};
    for (std::size_t i = 0; i < count; ++i)
        objects.append({app::Path(std::vector{paths.next()}), style});
    return objects;
}

/// All lines in one array with the boxes of its chunks: what the scene of blocks is compared with.
class ArrayScene {
public:
    explicit ArrayScene(const app::SceneLines& lines)
    {
        for (const auto& run : lines.runs())
            segments_.insert(segments_.end(), run.segments.begin(), run.segments.end());
        chunks_.update(segments_, 0, segments_.size());
        inside_.resize(segments_.size());
        outside_.resize(2 * segments_.size());
    }

    /// The milliseconds that clipping took; with Keep::Outside the call finds more.
    double clip(const clipping::Algorithm& algorithm, const clipping::Window& window,
                app::Keep keep)
    {
        const auto start = std::chrono::steady_clock::now();
        const std::size_t count = &algorithm == &clipping::exactAlgorithm()
                                      ? chunks_.clipAll(segments_, window, inside_)
                                      : algorithm.corrected.clipAll(segments_, window, inside_);
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        if (keep == app::Keep::Outside)
            clipping::outsideAll(segments_, std::span(inside_).first(count), outside_);
        return time.count();
    }

private:
    std::vector<clipping::Segment> segments_;
    clipping::Chunks chunks_;
    std::vector<clipping::Clipped> inside_, outside_;
};

/// In the middle of the page, so much of its area.
clipping::Window windowOf(double share)
{
    const app::Point half = pageSize * (std::sqrt(share) / 2), centre = pageSize / 2.0;
    return {centre - half, centre + half};
}

/// Milliseconds of both scenes.
struct Turns {
    std::vector<double> oldCalls, oldClips, newCalls, newClips;

    void print(const char* algorithm, double share) const
    {
        QTextStream(stdout) << QString::asprintf(
            "%-20.20s%5.2f%8.3f ->%8.3f, ratio %.3f;%8.3f ->%8.3f, ratio %.3f\n", algorithm, share,
            median(oldClips), median(newClips), ratio(newClips, oldClips), median(oldCalls),
            median(newCalls), ratio(newCalls, oldCalls));
    }

private:
    static double ratio(const std::vector<double>& some, const std::vector<double>& others)
    {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < some.size(); ++i)
            ratios.push_back(some[i] / others[i]);
        return median(ratios);
    }
};

// As painting a picture does.
void emptyCaches()
{
    static std::vector<std::uint64_t> other(12 << 20); // 96 MiB
    for (auto& word : other)
        ++word;
}

class Benchmark {
public:
    Benchmark(std::size_t segments, std::size_t each)
        : segments_(double(segments)), start_(allocatedBytes())
    {
        objects_ = someObjects(segments / each, each);
        printBytes("objects");
        table_.print("make the scene",
                     processorTime([&] { blocks_.update(objects_, {}, tolerance); }), "ms");
        printBytes("objects and scene");
    }

    void edits()
    {
        const std::size_t last = objects_.size() - 1;
        for (const auto& [where, first] :
             {std::pair("bottom", std::size_t(0)), {"middle", last / 2}, {"top", last}}) {
            Figures splice, update;
            for (int i = 0; i < rounds; ++i) {
                app::Objects moved = objects_.slice(0, 0);
                app::ObjectRow row = objects_[first].row();
                row.path = row.path.placed({{1, 1}, {0.5, 0.25}});
                moved.append(row);
                splice.times.push_back(processorTime([&] { objects_.splice(first, 1, moved); }));
                update.times.push_back(
                    processorTime([&] { blocks_.update(objects_, {}, tolerance); }));
            }
            table_.print((std::string("exchange 1 object, ") + where).c_str(), splice);
            table_.print("    update the scene", update);
        }
        app::ObjectRanges hidden;
        hidden.insert(app::ObjectRange{0, objects_.size() / 2});
        table_.print("hide half of it",
                     processorTime([&] { blocks_.update(objects_, hidden, tolerance); }), "ms");
        table_.print("show it again",
                     processorTime([&] { blocks_.update(objects_, {}, tolerance); }), "ms");
    }

    void frames()
    {
        array_ = std::make_unique<ArrayScene>(blocks_.lines());
        QTextStream(stdout)
            << "Share of the page; ms of clipping, one array -> blocks; of the call\n";
        for (const char* key : {"exact", "matthes-drakopoulos", "cohen-sutherland"})
            for (const double share : {0.0, 0.01, 0.1, 0.25, 0.5, 0.9, 1.2})
                frames(*clipping::findAlgorithm(key), share, app::Keep::Inside);
        QTextStream(stdout) << "keep outside\n";
        for (const double share : {0.01, 0.5})
            frames(clipping::exactAlgorithm(), share, app::Keep::Outside);
    }

    void several()
    {
        app::ClipRegion region;
        for (int i = 0; i < 4; ++i)
            region.steps.push_back({windowOf(0.8 - 0.2 * i), i % 2 ? app::WindowOperation::CutOut
                                                                   : app::WindowOperation::Add});
        for (const char* key : {"exact", "matthes-drakopoulos"}) {
            const app::Variant variant{clipping::findAlgorithm(key)};
            table_.print((std::string("four windows, ") + key).c_str(),
                         Figures::of(rounds, [&](int) { blocks_.clip(region, variant); }));
        }
    }

private:
    // The whole call, and what it says that the clipping took, in turns.
    void frames(const clipping::Algorithm& algorithm, double share, app::Keep keep)
    {
        const clipping::Window window = windowOf(share);
        const app::ClipRegion region{{{window, app::WindowOperation::Add}}, keep};
        Turns turns;
        for (int i = 0; i < rounds; ++i) {
            emptyCaches();
            double clipped = 0;
            turns.oldCalls.push_back(
                processorTime([&] { clipped = array_->clip(algorithm, window, keep); }));
            turns.oldClips.push_back(clipped);
            emptyCaches();
            app::SceneFrame frame;
            turns.newCalls.push_back(
                processorTime([&] { frame = blocks_.clip(region, {&algorithm}); }));
            turns.newClips.push_back(double(frame.nanoseconds) * 1e-6);
        }
        turns.print(algorithm.key.data(), share);
    }
    void printBytes(const char* what)
    {
        table_.print(what, double(allocatedBytes() - start_) / segments_, "bytes a segment");
    }

    FigureTable table_;
    double segments_;
    std::size_t start_;
    app::Objects objects_;
    BlockScene blocks_;
    std::unique_ptr<ArrayScene> array_;
};

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const auto arguments = QCoreApplication::arguments();
    const std::size_t each = arguments.value(1) == "polylines" ? 100 : 1;
    const std::size_t segments = arguments.value(2).toULongLong();
    Benchmark benchmark(segments > 0 ? segments : 1'000'000, each);
    benchmark.edits();
    benchmark.frames();
    benchmark.several();
}
