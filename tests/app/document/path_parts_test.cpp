// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/path.h"

#include <QTest>

#include <cstring>

#include "tests/app/document/random_documents.h"
#include "tests/test_class.h"

namespace document_path_parts_test {

using namespace app;

namespace {

bool sameBits(const Path& a, const Path& b)
{
    const auto x = a.parts(), y = b.parts();
    return a == b && x.has_value() == y.has_value()
           && (!x || std::memcmp(&x->placement, &y->placement, sizeof x->placement) == 0);
}

} // namespace

class PathPartsTest : public QObject {
    Q_OBJECT

private slots:
    // After the same moves, too: the placement is restored, not just the points.
    void restoreEveryBit()
    {
        RandomDocuments random(1);
        int packed = 0;
        for (int i = 0; i < 2000; ++i) {
            Path path = random.object().path.placed({{1, 1}, random.point()});
            const auto parts = path.parts();
            if (!parts)
                continue;
            ++packed;
            const std::vector<Point> points(parts->points.begin(), parts->points.end());
            const auto again = Path::of({parts->placement, points, parts->sizes, parts->kinds});
            QVERIFY(again && sameBits(*again, path));
            const Placement next{{1, 1}, random.point()};
            QVERIFY(sameBits(again->placed(next), path.placed(next)));
            QVERIFY(sameBits(path.placed(next).withPlacement(parts->placement), path));
        }
        QVERIFY(packed > 500);
    }
    void thatDoNotFitTogetherAreRefused()
    {
        const std::vector<Point> points(4);
        const std::vector<std::uint32_t> one{3 << 1}, two{1 << 1, 1 << 1}, tooMany{~0U};
        const std::vector<std::uint8_t> curve{1}, line{0}, strange{2};
        const std::vector<std::uint32_t> single{1 << 1};
        QVERIFY(Path::of({{}, points, one, {}}));
        QVERIFY(Path::of({{}, points, two, {}}));
        QVERIFY(Path::of({{}, points, single, curve}));
        QVERIFY(!Path::of({{}, points, single, {}}));
        QVERIFY(!Path::of({{}, points, single, line}));
        QVERIFY(!Path::of({{}, points, single, strange}));
        QVERIFY(!Path::of({{}, points, one, curve}));
        QVERIFY(!Path::of({{}, points, tooMany, {}}));
        QVERIFY(!Path::of({{}, points, {}, {}}));
        QVERIFY(!Path::of({}));
    }
    void linesHaveNone()
    {
        QVERIFY(!Path(clipping::Segment{{1, 2}, {3, 4}}).parts());
        QVERIFY(!Path().parts());
    }
};

} // namespace document_path_parts_test

TEST_CLASS(document_path_parts_test::PathPartsTest, None)
#include "tests/app/document/path_parts_test.moc"
