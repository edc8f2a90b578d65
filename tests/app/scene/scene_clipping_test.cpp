// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/area_windows.h"
#include "app/scene/scene_clipping.h"
#include "clipping/outside.h"
#include "clipping/region/catalogue.h"

#include <QTest>

#include <glm/common.hpp>

#include <limits>
#include <memory>
#include <set>

#include "tests/app/document/kept_in.h"
#include "tests/app/document/twin_document.h"
#include "tests/app/scene/block_scene.h"
#include "tests/busy_threads.h"
#include "tests/test_class.h"

namespace scene_scene_clipping_test {

namespace {

using app::ClipRegion;
using app::Keep;
using app::Remains;
using app::WindowOperation;
using clipping::Clipped;
using clipping::Form;
using clipping::Segment;
using clipping::Window;
using Pieces = std::vector<Clipped>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

std::size_t linesOf(const Pieces& pieces)
{
    std::set<std::uint32_t> sources;
    for (const Clipped& piece : pieces)
        sources.insert(piece.source);
    return sources.size();
}

std::size_t listed(const app::SceneFrame& frame)
{
    std::size_t count = 0;
    for (const auto& block : frame.blocks)
        count += block.pieces.size();
    return count;
}

/// Whether every chunk says what its lines show, as far as it can be seen from outside.
bool settled(const app::SceneFrame& frame)
{
    for (const auto& block : frame.blocks)
        if (block.remains.size() != block.block->chunks.size()
            || !std::ranges::is_sorted(block.pieces, {}, &Clipped::source))
            return false;
    return true;
}

/// Each form of each row.
std::vector<app::Variant> variants()
{
    std::vector<app::Variant> all;
    for (const auto& algorithm : clipping::algorithms())
        for (const Form form : {Form::Corrected, Form::Published})
            if (clipping::functionsOf(algorithm, form))
                all.push_back({&algorithm, form});
    return all;
}

const char* keyText(const app::Variant& variant) { return variant.algorithm->key.data(); }

/// What one call on all lines, and `fold` line by line, keep.
Pieces folded(std::span<const Segment> lines, const ClipRegion& region, app::ClipAll clipAll)
{
    std::vector<Pieces> atStep;
    for (const auto& step : region.steps) {
        Pieces& pieces = atStep.emplace_back(lines.size());
        pieces.resize(clipAll(lines, step.box, pieces));
    }
    std::vector<std::size_t> next(region.steps.size());
    Pieces kept;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        std::vector<std::optional<Clipped>> ofLine(region.steps.size());
        for (std::size_t s = 0; s < atStep.size(); ++s)
            if (next[s] < atStep[s].size() && atStep[s][next[s]].source == i)
                ofLine[s] = atStep[s][next[s]++];
        fold(region, lines[i], i, ofLine, kept);
    }
    return kept;
}

/// What a scene should keep: the row `exact` has a form for regions, other rows are folded.
Pieces keptOf(std::span<const Segment> lines, const ClipRegion& region, const app::Variant& variant)
{
    const auto clipAll = clipping::functionsOf(*variant.algorithm, variant.form)->clipAll;
    const auto* form = clipping::findRegionAlgorithm(variant.algorithm->key);
    if (!form || variant.form == Form::Published || region.steps.size() == 1)
        return folded(lines, region, clipAll);
    const auto prepared = app::areaWindows(region);
    Pieces kept;
    for (std::uint32_t i = 0; i < lines.size(); ++i)
        for (const clipping::RegionPiece& piece : form->clip(lines[i], *prepared)) {
            const auto edge = [](auto number) {
                return number ? app::borderEdge : clipping::Edge::NoEdge;
            };
            kept.push_back(
                {piece.segment, i, clipping::cutAt(edge(piece.edgeOfA), edge(piece.edgeOfB))});
        }
    return kept;
}

/// A document, today's scene of it, and the new one.
class Scenes {
public:
    explicit Scenes(std::uint64_t seed) : document(seed), scene(document.drawing) {}

    void follow()
    {
        blocks.update(document.objects, document.hidden,
                      app::usualTolerance(document.drawing.sheet().page));
    }
    Window randomWindow()
    {
        const app::Point a = document.randomPoint(), b = document.randomPoint();
        const Window window{glm::min(a, b), glm::max(a, b)};
        switch (document.random() % 12) {
        case 0:
            return {a, a};
        case 1:
            return {glm::max(a, b), glm::min(a, b)};
        case 2:
            return {{-1e9, -1e9}, {1e9, 1e9}};
        case 3:
            return {{a.x, -infinity}, {infinity, b.y}};
        case 4:
            return {a, {b.x, notANumber}};
        case 5:
            return {a, a + 3.0};
        default:
            return window;
        }
    }
    ClipRegion randomRegion(std::size_t windows)
    {
        ClipRegion region;
        region.keep = document.random() % 2 ? Keep::Inside : Keep::Outside;
        for (std::size_t i = 0; i < windows; ++i)
            region.steps.push_back({randomWindow(), WindowOperation(document.random() % 3)});
        return region;
    }
    /// Whether both scenes show the same at one window.
    bool agree(const Window& window, const app::Variant& variant)
    {
        const auto& uses = *clipping::functionsOf(*variant.algorithm, variant.form);
        const PlainScene::Frame old = scene.clip(uses, window);
        for (const Keep keep : {Keep::Inside, Keep::Outside}) {
            const auto operation =
                document.random() % 2 ? WindowOperation::Add : WindowOperation::Intersect;
            const ClipRegion region{{{window, operation}}, keep};
            const app::SceneFrame frame = blocks.clip(region, variant);
            const Pieces all = keptIn(frame);
            if (!same(all, keep == Keep::Inside ? old.inside : old.outside) || !settled(frame)
                || frame.total != scene.segments().size() || frame.visible != linesOf(all))
                return false;
        }
        return true;
    }

    TwinDocument document;
    PlainScene scene;
    BlockScene blocks;
};

} // namespace

class SceneClippingTest : public QObject {
    Q_OBJECT

private slots:
    void oneWindowShowsWhatAllLinesShow()
    {
        Scenes scenes(1);
        std::size_t seen = 0;
        for (int round = 0; round < 100; ++round) {
            scenes.document.editAtRandom();
            scenes.follow();
            const Window window = scenes.randomWindow();
            for (const app::Variant& variant : variants())
                QVERIFY2(scenes.agree(window, variant), keyText(variant));
            seen += scenes.blocks.lines().size();
        }
        QVERIFY(seen > 30'000);
    }

    void severalWindowsAreFolded()
    {
        Scenes scenes(2);
        for (int i = 0; i < 10; ++i)
            scenes.document.editAtRandom();
        for (int round = 0; round < 100; ++round) {
            scenes.document.editAtRandom();
            scenes.follow();
            const ClipRegion region = scenes.randomRegion(1 + scenes.document.random() % 5);
            for (const app::Variant& variant : variants()) {
                const app::SceneFrame frame = scenes.blocks.clip(region, variant);
                const Pieces all = keptIn(frame);
                if (!region.single()) // fold drops what is not finite
                    QVERIFY2(same(all, keptOf(scenes.scene.segments(), region, variant)),
                             keyText(variant));
                QCOMPARE(frame.visible, linesOf(all));
                QVERIFY(settled(frame));
            }
        }
    }

    void hostileNumbers()
    {
        Scenes scenes(3);
        const std::array numbers{0.0,   -0.0,       1.0,    50.0,     1e30,      -1e30, 3.5e38,
                                 1e300, notANumber, -1e308, infinity, -infinity, 5e-324};
        const auto any = [&] { return numbers[scenes.document.random() % numbers.size()]; };
        for (int round = 0; round < 100; ++round) {
            for (int i = 0; i < 40; ++i) {
                app::Shape shape;
                shape.paths.push_back({{any(), any()}, {{{any(), any()}}}, false});
                scenes.document.append(i % 2 ? shape : scenes.document.randomShape());
            }
            scenes.follow();
            const Window window =
                round % 2 ? Window{{any(), any()}, {any(), any()}} : scenes.randomWindow();
            const ClipRegion several = scenes.randomRegion(3);
            for (const app::Variant& variant : variants()) {
                QVERIFY2(scenes.agree(window, variant), keyText(variant));
                QVERIFY2(same(keptIn(scenes.blocks.clip(several, variant)),
                              keptOf(scenes.scene.segments(), several, variant)),
                         keyText(variant));
            }
            scenes.document.splice(0, scenes.document.size(), {});
        }
    }

    // Blocks are clipped by several threads, or by one while the others are busy.
    void manyBlocksAreClippedAsInOneCall_data()
    {
        QTest::addColumn<bool>("busy");
        QTest::newRow("free threads") << false;
        QTest::newRow("busy threads") << true;
    }
    void manyBlocksAreClippedAsInOneCall()
    {
        QFETCH(bool, busy);
        const auto others = busy ? std::make_unique<BusyThreads>() : nullptr;
        Scenes scenes(7);
        std::vector<app::Shape> shapes(20'000);
        for (app::Shape& shape : shapes) {
            const app::Point from = scenes.document.randomPoint();
            shape.style.width = double(1 + scenes.document.random() % 3);
            shape.paths.push_back({from, {{from + scenes.document.randomPoint() * 0.2}}, false});
        }
        scenes.document.splice(0, 0, std::move(shapes));
        scenes.follow();
        QVERIFY(scenes.blocks.lines().blocks().size() > 3);
        for (const std::size_t windows : {1, 1, 3}) {
            const ClipRegion region = scenes.randomRegion(windows);
            for (const app::Variant& variant : variants()) {
                const app::SceneFrame frame = scenes.blocks.clip(region, variant);
                const Pieces all = keptIn(frame);
                if (!region.single())
                    QVERIFY2(same(all, keptOf(scenes.scene.segments(), region, variant)),
                             keyText(variant));
                QCOMPARE(frame.visible, linesOf(all));
                QVERIFY(frame.nanoseconds > 0);
                QVERIFY(settled(frame));
            }
            const app::Point corner = scenes.document.randomPoint();
            for (const app::Variant& variant : variants())
                QVERIFY2(scenes.agree({corner, corner + 30.0}, variant), keyText(variant));
        }
    }

    void withoutAWindowAllIsWhole()
    {
        Scenes scenes(4);
        for (int i = 0; i < 30; ++i)
            scenes.document.append(scenes.document.randomShape());
        scenes.follow();
        for (const Keep keep : {Keep::Inside, Keep::Outside}) {
            const auto frame =
                scenes.blocks.clip({{}, keep}, {&clipping::exactAlgorithm(), Form::Corrected});
            QCOMPARE(frame.visible, scenes.scene.segments().size());
            QCOMPARE(listed(frame), std::size_t(0));
            QCOMPARE(keptIn(frame).size(), frame.total);
            QCOMPARE(frame.nanoseconds, std::uint64_t(0));
        }
    }

    // Lists only what lies at the edges; for other algorithms it finds out what else is whole.
    void mostChunksAreGoneOrWhole()
    {
        TwinDocument document(5);
        app::Subpath path{{0, 0}, {}, false};
        for (int i = 1; i <= 100'000; ++i)
            path.segments.push_back({{i * 0.001, double(i % 2)}});
        app::Shape shape;
        shape.paths.push_back(path);
        document.append(shape);
        BlockScene scene;
        scene.update(document.objects, {}, 1);
        QVERIFY(scene.lines().blocks().size() > 1);
        const ClipRegion inside{{{{{25, -1}, {75, 2}}, WindowOperation::Add}}, Keep::Inside};
        ClipRegion outside = inside;
        outside.keep = Keep::Outside;
        ClipRegion ring = inside;
        ring.steps.push_back({{{40, -1}, {60, 2}}, WindowOperation::CutOut});
        for (const app::Variant& variant : variants())
            for (const ClipRegion& region : {inside, outside, ring}) {
                const auto frame = scene.clip(region, variant);
                QVERIFY2(listed(frame) <= 4 * app::SceneBlock::mostInChunk, keyText(variant));
                if (variant.form == Form::Corrected)
                    QVERIFY(frame.visible >= 30'000 && frame.visible <= 50'002);
            }
    }

    // A published form may return anything, and say that nothing was cut.
    void wholeIsOnlyWhatIsTheLineItself()
    {
        TwinDocument document(6);
        app::Shape shape;
        shape.paths.push_back({{0, 0}, {{{1, 0}}, {{1, 1}}}, false});
        document.append(shape);
        const auto lines = app::linesOf(document.objects, {}, 1);
        const ClipRegion region{{{{{-9, -9}, {9, 9}}, WindowOperation::Add}}, Keep::Inside};
        constexpr app::ClipAll asTheyAre = [](auto in, const auto&, auto out) {
            for (std::uint32_t i = 0; i < in.size(); ++i)
                out[i] = {in[i], i, 0};
            return in.size();
        };
        constexpr app::ClipAll withAnotherZero = [](auto in, const auto&, auto out) {
            for (std::uint32_t i = 0; i < in.size(); ++i)
                out[i] = {{{in[i].a.x, -in[i].a.y}, in[i].b}, i, 0};
            return in.size();
        };
        constexpr app::ClipAll oneOfThem = [](auto in, const auto&, auto out) {
            out[0] = {in[1], 1, 0};
            return std::size_t(1);
        };
        app::SceneClipping clipping;
        QCOMPARE(clipping.clip(lines, region, asTheyAre).blocks[0].remains[0], Remains::Whole);
        for (const app::ClipAll lie : {withAnotherZero, oneOfThem}) {
            const auto frame = clipping.clip(lines, region, lie);
            QCOMPARE(frame.blocks[0].remains[0], Remains::Pieces);
            QVERIFY(same(keptIn(frame), frame.blocks[0].pieces));
        }
    }
};

} // namespace scene_scene_clipping_test

TEST_CLASS(scene_scene_clipping_test::SceneClippingTest, None)
#include "tests/app/scene/scene_clipping_test.moc"
