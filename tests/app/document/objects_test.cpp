// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/objects.h"

#include <QTest>

#include <algorithm>

#include "tests/app/document/random_objects.h"
#include "tests/test_class.h"

namespace document_objects_test {

using namespace app;

namespace {

bool allEqual(const auto& column)
{
    return std::ranges::all_of(column, [&](const auto& one) { return one == column.front(); });
}

// What is wrong with the columns of a block; "" if nothing is.
const char* fault(const ObjectBlock& block)
{
    const auto oneEach = [&](const auto& column) { return column.size() == block.size(); };
    const auto isLine = [](const Path& path) { return path.singleLine().has_value(); };
    const auto isNone = [](const auto& one) { return *one == Particulars{}; };
    if (block.size() == 0)
        return "empty";
    if (!block.lines.empty() && !block.paths.empty())
        return "two columns of paths";
    if (!block.paths.empty() && std::ranges::all_of(block.paths, isLine))
        return "paths that are all lines";
    if (block.styles.size() != 1 && (!oneEach(block.styles) || allEqual(block.styles)))
        return "styles";
    if (!block.hidden.empty()
        && (!oneEach(block.hidden) || std::ranges::none_of(block.hidden, std::identity())))
        return "hidden";
    if (!block.particulars.empty()
        && (!oneEach(block.particulars) || std::ranges::all_of(block.particulars, isNone)))
        return "particulars";
    std::uint32_t points = std::uint32_t(2 * block.lines.size());
    for (const Path& path : block.paths)
        points += weight(path);
    if (points != block.points)
        return "points";
    if (points > ObjectBlock::mostPoints && block.size() > 1)
        return "should have been split";
    return "";
}

// What is wrong with the blocks; "" if nothing is.
const char* fault(const Objects& objects)
{
    std::size_t first = 0;
    const Shared<ObjectBlock>* before = nullptr;
    for (std::size_t i = 0; i < objects.blocks().size(); ++i) {
        const Shared<ObjectBlock>& block = objects.blocks()[i];
        if (const char* const bad = fault(*block); *bad)
            return bad;
        if (objects.firstOf(i) != first || objects.blockOf(first) != i
            || objects.blockOf(first + block->size() - 1) != i)
            return "the number of its first object";
        first += block->size();
        if (before && std::min((*before)->points, block->points) < ObjectBlock::fewPoints
            && (*before)->points + block->points <= ObjectBlock::mostPoints)
            return "should have been joined";
        before = &block;
    }
    return objects.size() == first ? "" : "size";
}

std::vector<Splice> randomSplices(RandomObjects& random, std::size_t size)
{
    std::vector<Splice> splices;
    std::uint32_t at = 0;
    const bool small = random.whole(0, 1);
    for (int i = random.whole(0, 3) ? 1 : random.whole(2, 6); i > 0; --i) {
        at = std::uint32_t(random.whole(int(at), int(size)));
        const int left = int(size) - int(at);
        const int most = std::min(left, small ? 2 : size > 300 ? 60 : 20);
        splices.push_back({at, std::uint32_t(random.whole(0, most)),
                           std::uint32_t(random.whole(0, small ? 2 : 20))});
        at += splices.back().removed;
    }
    return splices;
}

// The same in a plain vector.
std::vector<Object> splice(std::vector<Object>& all, const std::vector<Splice>& splices,
                           const std::vector<Object>& added)
{
    std::vector<Object> removed, now;
    std::size_t at = 0, from = 0;
    const auto add = [](auto& to, const auto& source, std::size_t first, std::size_t end) {
        to.insert(to.end(), source.begin() + std::ptrdiff_t(first),
                  source.begin() + std::ptrdiff_t(end));
    };
    for (const Splice& s : splices) {
        add(now, all, at, s.first);
        add(now, added, from, from + s.added);
        at = s.first + s.removed;
        add(removed, all, s.first, at);
        from += s.added;
    }
    add(now, all, at, all.size());
    all = now;
    return removed;
}

std::vector<Splice> inverse(std::vector<Splice> splices)
{
    std::uint32_t shift = 0; // may go below 0 and comes back by wrapping round
    for (Splice& s : splices) {
        const Splice was = s;
        s = {was.first + shift, was.added, was.removed};
        shift += was.added - was.removed;
    }
    return splices;
}

struct Snapshot {
    Objects objects;
    std::vector<Object> expected;
    std::vector<const ObjectBlock*> blocks;
};

Objects loneLines(int count)
{
    Objects objects;
    const StyleEntry style = objects.styles().entryOf(Style{});
    for (int i = 0; i < count; ++i)
        objects.appendLine({Point(i, 0), Point(i, 1)}, style);
    return objects;
}

std::size_t blocksOfItsOwn(const Objects& objects, const Objects& others)
{
    std::vector<const ObjectBlock*> shared;
    for (const Shared<ObjectBlock>& block : others.blocks())
        shared.push_back(&*block);
    std::ranges::sort(shared);
    return std::size_t(std::ranges::count_if(objects.blocks(), [&](const auto& block) {
        return !std::ranges::binary_search(shared, &*block);
    }));
}

} // namespace

class ObjectsTest : public QObject {
    Q_OBJECT

private slots:
    void appendedOnesAreThere()
    {
        RandomObjects random(1);
        const std::vector<Object> all = random.some(3000);
        Objects objects;
        for (std::size_t i = 0; i < all.size(); ++i) {
            objects.append(all[i]);
            QCOMPARE(fault(*objects.blocks().back()), "");
        }
        QCOMPARE(fault(objects), "");
        QVERIFY(equal(objects, all));
        for (std::size_t i = 0; i < all.size(); i += 17) {
            QVERIFY(objects[i].copy() == all[i]);
            QVERIFY(objects[i].path() == all[i].path);
        }
        QVERIFY(Objects().empty());
        QCOMPARE(Objects().size(), std::size_t(0));
    }
    void tenThousandSplicesAgreeWithAVector()
    {
        RandomObjects random(2);
        std::vector<Object> expected = random.some(200);
        Objects objects = objectsOf(expected);
        std::vector<Snapshot> snapshots(6);
        std::size_t mostBlocks = 0, shared = 0;
        for (int step = 0; step < 10'000; ++step) {
            if (step % 37 == 0) { // another owner
                Snapshot& snapshot = snapshots[std::size_t(step / 37) % snapshots.size()];
                QVERIFY(equal(snapshot.objects, snapshot.expected));
                QCOMPARE(fault(snapshot.objects), "");
                for (std::size_t i = 0; i < snapshot.blocks.size(); ++i)
                    QCOMPARE(&*snapshot.objects.blocks()[i], snapshot.blocks[i]);
                snapshot = {objects, expected, {}};
                for (const Shared<ObjectBlock>& block : snapshot.objects.blocks())
                    snapshot.blocks.push_back(&*block);
            }
            const std::vector<Splice> splices = randomSplices(random, expected.size());
            int count = 0;
            for (const Splice& s : splices)
                count += int(s.added);
            const std::vector<Object> added = random.some(count);
            const Objects coming =
                random.whole(0, 1) ? objectsOf(added, objects.slice(0, 0)) : objectsOf(added);
            const Objects before = objects;
            const Objects removed = objects.splice(splices, coming);

            QVERIFY(equal(removed, splice(expected, splices, added)));
            QVERIFY(equal(objects, expected));
            QCOMPARE(fault(objects), "");
            QCOMPARE(fault(removed), "");
            QVERIFY(equal(coming, added));
            if (step % 10 == 0) {
                Objects again = objects;
                QVERIFY(again.splice(inverse(splices), removed) == coming);
                QVERIFY(again == before);
                QCOMPARE(fault(again), "");
            }
            mostBlocks = std::max(mostBlocks, objects.blocks().size());
            shared += objects.blocks().size() - blocksOfItsOwn(objects, before);
        }
        QVERIFY(mostBlocks > 20);
        QVERIFY(shared > 50'000);
    }
    void slicesAndSums()
    {
        RandomObjects random(3);
        const std::vector<Object> all = random.some(500);
        const Objects objects = objectsOf(all);
        for (int i = 0; i < 500; ++i) {
            const int first = random.whole(0, 500), end = random.whole(first, 500);
            const Objects part = objects.slice(std::size_t(first), std::size_t(end - first));
            QVERIFY(equal(part, {all.begin() + first, all.begin() + end}));
            QCOMPARE(fault(part), "");
            QVERIFY(blocksOfItsOwn(part, objects) <= 2);
            Objects sum = objects.slice(0, std::size_t(first));
            sum.append(part);
            sum.append(objects.slice(std::size_t(end), std::size_t(500 - end)));
            QVERIFY(sum == objects);
            QCOMPARE(fault(sum), "");
        }
        Objects twice = objects;
        twice.append(twice);
        QVERIFY(twice.slice(500, 500) == objects);
    }
    void columnsWidenAndNarrow()
    {
        Objects objects = loneLines(100);
        const auto block = [&]() -> const ObjectBlock& { return *objects.blocks()[0]; };
        QCOMPARE(block().lines.size(), std::size_t(100));
        QCOMPARE(block().styles.size(), std::size_t(1));
        QVERIFY(block().hidden.empty() && block().particulars.empty());

        Objects other = objects.slice(0, 0);
        Style wide;
        wide.width = 7;
        other.append({polyline(3, 1), wide, {"id"}, true});
        objects.splice(50, 1, other);
        QCOMPARE(objects.blocks().size(), std::size_t(1));
        QCOMPARE(block().paths.size(), std::size_t(100));
        QVERIFY(block().lines.empty());
        QCOMPARE(block().styles.size(), std::size_t(100));
        QCOMPARE(block().hidden.size(), std::size_t(100));
        QCOMPARE(block().particulars.size(), std::size_t(100));
        QCOMPARE(objects[50].particulars().id, "id");
        QVERIFY(objects[50].hidden() && !objects[49].hidden());
        QCOMPARE(objects[50].style(), wide);
        QVERIFY(!objects[50].singleLine());

        objects.splice(50, 1, loneLines(1));
        QCOMPARE(block().lines.size(), std::size_t(100));
        QCOMPARE(fault(objects), "");
    }
    // What a model of a vector cannot see: how little is copied.
    void aSpliceCopiesTheBlocksItTouches()
    {
        const Objects before = loneLines(100'000);
        for (const std::size_t at : {0UL, 50'000UL, 4096UL, 99'999UL}) {
            Objects objects = before;
            const Objects removed = objects.splice(at, 1, loneLines(1));
            QVERIFY(blocksOfItsOwn(objects, before) <= 3);
            QCOMPARE(objects.size(), before.size());
            QCOMPARE(removed[0].singleLine(), before[at].singleLine());
        }
        Objects all = before;
        const Objects removed = all.splice(0, all.size(), Objects());
        QVERIFY(all.empty());
        QCOMPARE(blocksOfItsOwn(removed, before), std::size_t(0));
        all.splice(0, 0, removed);
        QCOMPARE(blocksOfItsOwn(all, before), std::size_t(0));
        QVERIFY(all == before);
    }
    void equalHoweverTheyLieInBlocks()
    {
        RandomObjects random(4);
        std::vector<Object> all = random.some(300);
        const Objects straight = objectsOf(all);
        Objects backwards;
        for (std::size_t i = all.size(); i-- > 0;) { // other blocks, other numbers of styles
            Objects one;
            one.append(all[i]);
            backwards.splice(0, 0, one);
        }
        QVERIFY(straight == backwards);
        for (int i = 0; i < 200; ++i) {
            Object& object = all[std::size_t(random.whole(0, 299))];
            const Object was = object;
            switch (i % 4) {
            case 0:
                object.hidden = !object.hidden;
                break;
            case 1:
                object.style.width += 0.5;
                break;
            case 2:
                object.particulars.title = "other";
                break;
            default:
                object.path = object.path.pointCount() ? Path() : polyline(2, 0);
            }
            QVERIFY(objectsOf(all) != straight);
            object = was;
        }
        QVERIFY(straight != straight.slice(0, 299));
        QVERIFY(loneLines(10) == loneLines(10));
        Objects negative;
        negative.append({Path(clipping::Segment{{-0.0, 0}, {0, 1}}), Style{}});
        QVERIFY(loneLines(1) != negative);
    }
    void rowsKeepWhatTheyShare()
    {
        Objects objects, others;
        objects.append({polyline(100, 1), Style{}, {"a"}});
        others = objects.slice(0, 0);
        ObjectRow row = objects[0].row();
        row.path = row.path.placed({{1, 1}, {2, 0}});
        others.append(row);
        QCOMPARE(&others[0].particulars(), &objects[0].particulars());
        QCOMPARE(&others.styles(), &objects.styles());
        QVERIFY(others[0].path() == objects[0].path().placed({{1, 1}, {2, 0}}));
        QVERIFY(others[0].path() != objects[0].path());
    }
    // Whatever table the styles come from, and whether there is one yet.
    void rowsOfOtherTablesBringTheirStyles()
    {
        Objects from;
        for (int i = 0; i < 200; ++i)
            from.append({polyline(3, i), Style{.width = 0.1 * (i % 7)}});
        Objects other; // the same indices stand for other styles
        other.append({polyline(2, 1), Style{.width = 99}});
        for (const Objects& to : {Objects(), Objects().slice(0, 0), other, from.slice(0, 0)}) {
            Objects rows = to, lines = to;
            from.forEach(0, from.size(), [&](std::size_t, const ObjectView& object) {
                rows.append(object.row());
                lines.appendLine({{0, 0}, {1, 1}}, object.styleEntry());
            });
            const std::size_t before = to.size();
            QCOMPARE(rows.size(), before + from.size());
            QVERIFY(rows.slice(before, from.size()) == from);
            for (std::size_t i = 0; i < from.size(); ++i)
                QVERIFY(lines[before + i].style() == from[i].style());
            QVERIFY(to == rows.slice(0, before));
        }
    }
    void bytesOfItsOwn()
    {
        Objects lines = loneLines(100'000);
        QVERIFY(lines.bytesNotIn({}) > 32 * 100'000);
        QVERIFY(lines.bytesNotIn({}) < 33 * 100'000);
        const Objects copy = lines;
        QVERIFY(copy.bytesNotIn(lines) < 1000);
        QVERIFY(lines.bytesNotIn(lines.slice(50'000, 50'000)) < 18 * 100'000);

        const Path path = polyline(100, 0);
        const std::size_t alone = Path(path.subpaths()).heapPart().bytes;
        Objects paths;
        for (int i = 0; i < 1000; ++i)
            paths.append({Path(path.subpaths()), Style{}});
        QVERIFY(paths.bytesNotIn({}) > 1000 * alone);
        QVERIFY(paths.bytesNotIn({}) < 1000 * (alone + 60));
        Objects moved = paths.slice(0, 0);
        paths.forEach(0, 1000, [&](std::size_t, const ObjectView& object) {
            ObjectRow row = object.row();
            row.path = row.path.placed({{1, 1}, {5, 5}});
            moved.append(row);
        });
        QVERIFY(moved.bytesNotIn(paths) < 1000 * 60); // a move costs its placements
        QVERIFY(moved.bytesNotIn(paths.slice(1, 999)) < 1000 * 60 + 2 * alone);
        moved.append(moved.slice(0, 1000)); // which counts the points once
        QVERIFY(moved.bytesNotIn({}) < 1000 * (alone + 2 * 60));
    }
};

} // namespace document_objects_test

TEST_CLASS(document_objects_test::ObjectsTest, None)
#include "tests/app/document/objects_test.moc"
