// SPDX-License-Identifier: GPL-3.0-or-later
// What clipping/region/box_part.h says about a box is true of every segment in it.
#include "clipping/region/box_part.h"

#include <QTest>

#include <glm/common.hpp>

#include <array>

#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/shapes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace region_box_part_test {

using namespace clipping;

namespace {

Window boxAt(const glm::dvec2& p, const glm::dvec2& q) { return {glm::min(p, q), glm::max(p, q)}; }

/// Whether a segment is kept whole or not at all, as the box says.
bool isTrue(BoxPart part, const Segment& s, const PreparedRegion& region)
{
    const auto pieces = clip(s, region);
    if (part == BoxPart::None)
        return pieces.empty();
    return part == BoxPart::Undecided || (pieces.size() == 1 && sameBits(pieces[0].segment, s));
}

} // namespace

class BoxPartTest : public QObject {
    Q_OBJECT

private slots:
    void everySegmentInTheBoxAgrees()
    {
        Random random(61);
        std::array<int, 3> parts{};
        for (int i = 0; i < 2'000; ++i) {
            HostilePoints points(random, i % 8 != 0);
            const Region region = hostileRegion(random, points, 3);
            const PreparedRegion prepared(region);
            const glm::dvec2 p = points.next(), q = i % 3 == 0 ? points.next() : p / 2.0 + 0.5;
            const Window box = boxAt(p, q);
            const BoxPart part = partOf(box, prepared);
            ++parts[std::size_t(part)];
            const std::array corners{box.min, box.max, glm::dvec2(box.min.x, box.max.y),
                                     glm::dvec2(box.max.x, box.min.y),
                                     box.min / 2.0 + box.max / 2.0};
            for (const auto& a : corners)
                for (const auto& b : corners)
                    VERIFY_OR_SAY(isTrue(part, {a, b}, prepared), exactly({a, b}, region).c_str());
        }
        for (const int count : parts)
            QVERIFY2(count > 100, QByteArray::number(count));
    }
    void theWholeInsideOfAWindow()
    {
        const PreparedRegion window({{{areaOf({{0, 0}, {4, 4}})}}, Keep::Inside});
        QCOMPARE(partOf({{1, 1}, {3, 3}}, window), BoxPart::Whole);
        QCOMPARE(partOf({{5, 1}, {6, 3}}, window), BoxPart::None);
        QCOMPARE(partOf({{1, 1}, {4, 3}}, window), BoxPart::Undecided); // touches an edge
        QCOMPARE(partOf({{-1, -1}, {9, 9}}, window), BoxPart::Undecided);
        QCOMPARE(partOf({{2, 2}, {2, 2}}, window), BoxPart::Whole);
        QCOMPARE(partOf({{4, 2}, {4, 2}}, window), BoxPart::Undecided); // a point on an edge
        QCOMPARE(partOf({{4, 1}, {4, 2}}, window), BoxPart::Undecided); // along an edge
    }
    void withoutAreasAllOrNothing()
    {
        QCOMPARE(partOf({{0, 0}, {1, 1}}, PreparedRegion(Region{})), BoxPart::Whole);
        const PreparedRegion empty({{{Area{}}}, Keep::Inside});
        QCOMPARE(partOf({{0, 0}, {1, 1}}, empty), BoxPart::None);
    }
};

} // namespace region_box_part_test

TEST_CLASS(region_box_part_test::BoxPartTest, Core)
#include "tests/clipping/region/box_part_test.moc"
