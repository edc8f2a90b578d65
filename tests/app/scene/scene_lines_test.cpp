// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_block_cache.h"
#include "app/scene/scene_lines.h"

#include <QTest>

#include <cstring>
#include <limits>

#include "tests/app/document/twin_document.h"
#include "tests/test_class.h"

namespace scene_scene_lines_test {

namespace {

using app::SceneBlock;
using app::SceneLines;
using clipping::Segment;

bool sameBits(std::span<const Segment> a, std::span<const Segment> b)
{
    return a.size() == b.size()
           && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// What differs from the scene of the same drawing; nothing if nothing does.
const char* difference(const SceneLines& lines, const PlainScene& scene, std::size_t objects)
{
    if (lines.size() != scene.segments().size())
        return "number of lines";
    std::size_t next = 0;
    for (const auto& [firstLine, firstObject, segments] : lines.runs()) {
        if (firstLine != next
            || !sameBits(segments, scene.segments().subspan(next, segments.size())))
            return "lines";
        next += segments.size();
    }
    for (std::size_t i = 0; i <= objects; ++i)
        if (lines.firstLineOf(i) != scene.firstSegmentOf(i))
            return "first line of an object";
    for (std::size_t i = 0; i < objects; ++i) {
        const std::size_t first = scene.firstSegmentOf(i), end = scene.firstSegmentOf(i + 1);
        if (first < end && (lines.objectOf(first) != i || lines.objectOf(end - 1) != i))
            return "object of a line";
    }
    return next == lines.size() ? nullptr : "runs";
}

bool sameBoxes(const app::FloatBox& a, const app::FloatBox& b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool sameBlocks(const SceneBlock& a, const SceneBlock& b)
{
    const auto sameChunks = [](const app::SceneChunk& x, const app::SceneChunk& y) {
        return x.first == y.first && x.style == y.style && sameBoxes(x.box, y.box);
    };
    return sameBits(a.segments, b.segments) && std::ranges::equal(a.chunks, b.chunks, sameChunks)
           && std::ranges::equal(a.boxes, b.boxes, sameBoxes) && a.firstOfObject == b.firstOfObject
           && a.continues == b.continues;
}

bool sameBlocks(const SceneLines& a, const SceneLines& b)
{
    return std::ranges::equal(a.blocks(), b.blocks(),
                              [](const auto& x, const auto& y) { return sameBlocks(*x, *y); });
}

bool isIn(const app::Point& p, const app::FloatBox& box)
{
    return p.x >= double(box.minX) && p.x <= double(box.maxX) && p.y >= double(box.minY)
           && p.y <= double(box.maxY);
}

/// What a block does not keep of its promises; nothing if it keeps all.
const char* fault(const SceneBlock& block, const app::Objects& objects, std::size_t firstObject)
{
    if (block.segments.size() > SceneBlock::mostSegments)
        return "too many segments";
    if (block.boxes.size() != (block.chunks.size() + 15) / 16)
        return "number of boxes";
    for (std::size_t i = 0, begin = 0; i < block.chunks.size(); ++i) {
        const auto& [box, style, first] = block.chunks[i];
        const std::size_t end = block.endOfChunk(i);
        if (first != begin || end <= begin || end - begin > SceneBlock::mostInChunk)
            return "size of a chunk";
        for (std::size_t s = begin; s < end; ++s) {
            const auto& [a, b] = block.segments[s];
            if (!isIn(a, box) || !isIn(b, box) || !isIn(a, block.boxes[i / 16]))
                return "box";
            if (objects[firstObject + block.objectOf(s)].styleIndex() != style)
                return "style";
        }
        begin = end;
    }
    return nullptr;
}

const char* fault(const SceneLines& lines, const app::Objects& objects)
{
    for (std::size_t i = 0; i < lines.blocks().size(); ++i)
        if (const char* what = fault(*lines.blocks()[i], objects, lines.runs()[i].firstObject))
            return what;
    return nullptr;
}

/// The lines that an incremental scene has.
class Incremental {
public:
    const SceneLines& update(const TwinDocument& document, double tolerance)
    {
        if (cache_.update(document.objects, document.hidden, tolerance))
            lines_ = SceneLines(cache_.blocks());
        return lines_;
    }

private:
    app::SceneBlockCache cache_;
    SceneLines lines_;
};

app::Objects oneLine(double x)
{
    app::Objects objects;
    objects.appendLine({{x, 0}, {x, 1}}, objects.styles().entryOf({}));
    return objects;
}

app::Shape polyline(std::size_t segments)
{
    app::Subpath path{{0, 0}, {}, false};
    for (std::size_t i = 0; i < segments; ++i)
        path.segments.push_back({{double(i + 1), double(i % 7)}});
    app::Shape shape;
    shape.paths.push_back(path);
    return shape;
}

/// A zigzag from a place on.
app::Shape stroke(const app::Point& at, std::size_t segments)
{
    app::Shape shape = polyline(segments);
    auto& [start, path, closed] = shape.paths[0];
    start += at;
    for (app::PathSegment& segment : path)
        segment.to += at;
    return shape;
}

std::vector<std::size_t> chunkSizes(const TwinDocument& document)
{
    const SceneLines lines = app::linesOf(document.objects, document.hidden, 1);
    std::vector<std::size_t> sizes;
    for (const auto& block : lines.blocks())
        for (std::size_t i = 0; i < block->chunks.size(); ++i)
            sizes.push_back(block->endOfChunk(i) - block->chunks[i].first);
    return sizes;
}

/// The blocks that two scenes share.
std::size_t shared(const SceneLines& a, const SceneLines& b)
{
    std::size_t count = 0;
    for (const auto& block : a.blocks())
        count += std::size_t(std::ranges::count_if(
            b.blocks(), [&](const auto& other) { return sameAddress(block, other); }));
    return count;
}

} // namespace

class SceneLinesTest : public QObject {
    Q_OBJECT

private slots:
    void afterRandomEditsTheyAreThoseOfTheWholeDrawing()
    {
        TwinDocument document(1);
        const PlainScene scene(document.drawing);
        const double tolerance = app::usualTolerance(document.drawing.sheet().page);
        for (int i = 0; i < 40; ++i)
            document.append(polyline(1500));
        Incremental incremental;
        for (int round = 0; round < 1000; ++round) {
            document.editAtRandom();
            const SceneLines& lines = incremental.update(document, tolerance);
            if (const char* what = difference(lines, scene, document.size()))
                QFAIL(qPrintable(QStringLiteral("edit %1: %2").arg(round).arg(what)));
            if (round % 100 == 99) {
                QVERIFY(
                    sameBlocks(lines, app::linesOf(document.objects, document.hidden, tolerance)));
                if (const char* what = fault(lines, document.objects))
                    QFAIL(what);
            }
        }
        QVERIFY(incremental.update(document, tolerance).blocks().size() > 5);
    }

    void anEditMakesOnlyTheBlocksThatItTouches()
    {
        TwinDocument document(2);
        for (int i = 0; i < 100; ++i)
            document.append(polyline(1000));
        Incremental incremental;
        const SceneLines before = incremental.update(document, 1);
        for (const std::size_t at : {std::size_t(0), std::size_t(50), std::size_t(99)}) {
            document.splice(at, 1, {document.randomShape()});
            const SceneLines after = incremental.update(document, 1);
            QVERIFY(shared(before, after) >= before.blocks().size() - 6);
        }
        document.setVisible(0, false); // all of them
        QCOMPARE(incremental.update(document, 1).size(), std::size_t(0));
        document.setVisible(0, true);
        QVERIFY(incremental.update(document, 1).size() > 95'000);
    }

    void nothingIsMadeWithoutNeed()
    {
        TwinDocument document(3);
        document.append(polyline(10));
        app::SceneBlockCache cache;
        QVERIFY(cache.update(document.objects, document.hidden, 1));
        QVERIFY(!cache.update(document.objects, document.hidden, 1));
        QVERIFY(cache.update(document.objects, document.hidden, 2));
        document.append(polyline(10));
        QVERIFY(cache.update(document.objects, document.hidden, 2));
    }

    // The memory of a block that has gone may be used for the next one.
    void anotherBlockNeverPassesForTheOldOne()
    {
        app::SceneBlockCache cache;
        for (int i = 0; i < 100; ++i) {
            cache.update(oneLine(i), {}, 1);
            QCOMPARE(cache.blocks()[0]->segments[0].a.x, double(i));
        }
    }

    void aBlockMayBeThereTwice()
    {
        TwinDocument document(4);
        for (int i = 0; i < 20; ++i)
            document.append(polyline(1000));
        app::Objects twice = document.objects;
        twice.append(document.objects);
        app::SceneBlockCache cache;
        cache.update(document.objects, {}, 1);
        const app::ObjectRanges hidden(app::ObjectRange{3, 25}); // other ones in each
        cache.update(twice, hidden, 1);
        QVERIFY(sameBlocks(SceneLines(cache.blocks()), app::linesOf(twice, hidden, 1)));
        QCOMPARE(SceneLines(cache.blocks()).size(), std::size_t(18'000));
        cache.update(twice, {}, 1);
        QVERIFY(sameBlocks(SceneLines(cache.blocks()), app::linesOf(twice, {}, 1)));
    }

    void aLongPathSpansBlocks_data()
    {
        QTest::addColumn<std::size_t>("before");
        QTest::addColumn<std::size_t>("segments");
        constexpr std::size_t most = SceneBlock::mostSegments;
        for (const std::size_t before : {std::size_t(0), std::size_t(1), std::size_t(100)})
            for (const std::size_t segments : {most - before - 1, most - before, most - before + 1,
                                               2 * most - before, 3 * most + 17})
                QTest::addRow("%zu and %zu", before, segments) << before << segments;
    }

    void aLongPathSpansBlocks()
    {
        QFETCH(std::size_t, before);
        QFETCH(std::size_t, segments);
        TwinDocument document(5);
        std::vector<app::Shape> shapes(before, polyline(1));
        shapes.push_back(polyline(segments));
        shapes.push_back(polyline(5));
        shapes.back().hidden = true;
        shapes.push_back(polyline(1));
        shapes.back().style.width = 2;
        document.splice(0, 0, shapes);
        app::ObjectBlock block; // of all, although such a path would get one of its own
        for (std::size_t i = 0; i < document.size(); ++i)
            block.append(document.objects[i].row(), document.objects[i].styleIndex());
        const PlainScene scene(document.drawing);
        const SceneLines lines(app::sceneBlocksOf(block, {}, 1));
        if (const char* what = difference(lines, scene, document.size()))
            QFAIL(what);
        if (const char* what = fault(lines, document.objects))
            QFAIL(what);
        const std::size_t first = lines.firstLineOf(before);
        for (std::size_t i = first; i < first + segments; ++i)
            if (lines.objectOf(i) != before)
                QFAIL(qPrintable(QString::number(i)));
        QCOMPARE(std::ranges::count_if(lines.blocks(), [](const auto& b) { return b->continues; }),
                 std::ptrdiff_t((before + segments - 1) / SceneBlock::mostSegments));
        QCOMPARE(lines.blocks().size(), (before + segments) / SceneBlock::mostSegments + 1);
    }

    // Few points, many segments: one object block makes several blocks of several objects.
    void curvesThatFillMoreThanABlock()
    {
        TwinDocument document(6);
        std::vector<app::Shape> shapes;
        for (int i = 0; i < 60; ++i) {
            shapes.push_back(document.randomShape());
            app::Shape& curve = shapes.emplace_back();
            curve.hidden = i % 7 == 0;
            const double far = 1e5 * double(1 + i);
            curve.paths.push_back({{0, 0}, {{{far, 0}, {0, far}, {far, far}, true}}, false});
        }
        document.splice(0, 0, shapes);
        const PlainScene scene(document.drawing);
        const double tolerance = app::usualTolerance(document.drawing.sheet().page);
        const SceneLines lines = app::linesOf(document.objects, document.hidden, tolerance);
        QCOMPARE(document.objects.blocks().size(), std::size_t(1));
        QVERIFY(lines.blocks().size() > 3);
        if (const char* what = difference(lines, scene, document.size()))
            QFAIL(what);
        if (const char* what = fault(lines, document.objects))
            QFAIL(what);
    }

    void aChunkEndsWhereThePenIsLifted()
    {
        using Sizes = std::vector<std::size_t>;
        TwinDocument apart(9), over(9), short_(9);
        for (int i = 0; i < 4; ++i) {
            apart.append(stroke({0, 10.0 * i}, 20));
            over.append(stroke({i, i}, 20));
            short_.append(stroke({0, 10.0 * i}, 5));
        }
        QCOMPARE(chunkSizes(apart), (Sizes{20, 20, 20, 20}));
        QCOMPARE(chunkSizes(over), (Sizes{60, 20})); // lest a chunk have more than 64
        QCOMPARE(chunkSizes(short_), (Sizes{10, 10}));
        apart.append(stroke({0, 100}, 130));
        QCOMPARE(chunkSizes(apart), (Sizes{20, 20, 20, 20, 64, 64, 2}));
        over.splice(1, 1, {});
        app::Shape other = stroke({1, 1}, 20);
        other.style.width = 5;
        over.splice(1, 0, {other});
        QCOMPARE(chunkSizes(over), (Sizes{20, 20, 40}));
        other.hidden = true;
        over.splice(1, 1, {other});
        QCOMPARE(chunkSizes(over), (Sizes{60}));
    }

    void linesAllOverThePageAreFullChunks()
    {
        TwinDocument all(10), hatched(10);
        std::vector<app::Shape> lines, hatching;
        for (int i = 0; i < 6400; ++i) {
            const app::Point at = all.randomPoint();
            lines.push_back(stroke(at, 1));
            hatching.push_back(stroke({0, i}, 1));
        }
        all.splice(0, 0, lines);
        hatched.splice(0, 0, hatching);
        QVERIFY(chunkSizes(all).size() < 150);
        QCOMPARE(chunkSizes(hatched).size(), std::size_t(800));
    }

    void singleLinesNeedNoListOfObjects()
    {
        TwinDocument document(7);
        for (int i = 0; i < 100; ++i)
            document.append(polyline(1));
        QVERIFY(app::linesOf(document.objects, {}, 1).blocks()[0]->firstOfObject.empty());
        const SceneLines some = app::linesOf(document.objects, app::ObjectRanges{0}, 1);
        QCOMPARE(some.size(), std::size_t(99));
        QCOMPARE(some.objectOf(0), std::size_t(1));
    }

    void copiesStayAndHaveTheSameRevision()
    {
        TwinDocument document(8);
        document.append(polyline(3));
        Incremental incremental;
        QCOMPARE(SceneLines().revision(), std::uint64_t(0));
        QCOMPARE(SceneLines().firstLineOf(0), std::size_t(0));
        const SceneLines before = incremental.update(document, 1);
        QCOMPARE(incremental.update(document, 1).revision(), before.revision());
        const Segment last = before[2];
        document.splice(0, 1, {polyline(2)});
        QVERIFY(incremental.update(document, 1).revision() != before.revision());
        QCOMPARE(before.size(), std::size_t(3));
        QCOMPARE(before[2], last);
    }

    void boxesOfHostileNumbers()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        const auto box = [](const Segment& s) { return app::boxAround(std::span(&s, 1)); };
        for (const double bad : {infinity, -infinity, nan})
            for (const Segment& s : {Segment{{bad, 0}, {1, 1}}, Segment{{0, 0}, {1, bad}}}) {
                const app::FloatBox b = box(s);
                QVERIFY(std::isnan(b.minX) && std::isnan(b.minY) && std::isnan(b.maxX)
                        && std::isnan(b.maxY));
                const app::FloatBox all = united(box({{0, 0}, {1, 1}}), b);
                QVERIFY(std::isnan(all.minX) && std::isnan(united(b, all).maxY));
            }
        for (const double number : {0.1, -0.1, 1e300, -1e300, 1e-300, -1e-300, 16777217.0, 5e-324,
                                    3.4028235677973366e38, std::numeric_limits<double>::max()}) {
            const app::FloatBox b = box({{number, number}, {number, number}});
            QVERIFY(isIn({number, number}, b));
            QVERIFY(std::nextafter(b.minX, INFINITY) >= b.maxX); // and no larger than need be
        }
    }
};

} // namespace scene_scene_lines_test

TEST_CLASS(scene_scene_lines_test::SceneLinesTest, None)
#include "tests/app/scene/scene_lines_test.moc"
