// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/error_class.h"
#include "app/exactness/magnifier_paint.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QTest>

#include <cmath>

#include "tests/test_class.h"

namespace exactness_magnified_test {

using namespace clipping;
using namespace app;

namespace {

constexpr Window paper{{-100, -75}, {100, 75}};
constexpr Segment slanted{{-160, -30}, {70, 130}};

Variant variant(const char* key) { return *findVariant(QString::fromLatin1(key)); }

MagnifierLook look() { return {chartLook(Ground::Light), 0xC2410C, 0x1D63C9, 0xA80F86, 0xE4E7EB}; }

QImage picture(const Magnified& seen, MagnifierView view)
{
    QImage image(400, 300, QImage::Format_RGB32);
    QPainter painter(&image);
    paintMagnified(painter, {0, 0, 400, 300}, {seen, "MD"}, view, look());
    return image;
}

} // namespace

class MagnifiedTest : public QObject {
    Q_OBJECT

private slots:
    void theExactEndIsWhereTheErrorSays()
    {
        for (const char* key : {"md", "lb:published", "cs", "skala", "exact"})
            for (const int end : {0, 1}) {
                const auto seen = magnified(variant(key), slanted, paper, end);
                const auto exactness = exactnessOf(variant(key), slanted, paper);
                QVERIFY(seen && seen->exactness);
                const double off =
                    std::max(std::abs(seen->exactness->x), std::abs(seen->exactness->y));
                QCOMPARE(off / seen->largestUlp, exactness->ends[std::size_t(end)].ulps);
                // The true end lies on the line: the way there is along it.
                const glm::dvec2 along = *seen->exactness - seen->onLine;
                const double across = along.x * seen->direction.y - along.y * seen->direction.x;
                QVERIFY(std::abs(across) <= 1e-10 * seen->largestUlp);
            }
    }

    void aLostLineHasItsExactEnd()
    {
        const Segment steep{{100, 0}, {100.5, 300}};
        const auto seen = magnified(variant("kwc:published"), steep, {{0, 10}, {300, 290}}, 0);
        QVERIFY(seen && !seen->returned && seen->exactness);
        QCOMPARE(seen->centre.y, 10.);
        QVERIFY(magnifiedText(*seen, "KWC").startsWith("KWC shows nothing"));
        const auto invented = magnified(variant("md:published"),
                                        {{-1, 1 + 0x1p-51}, {3, 1 - 0x1p-52}}, {{0, 0}, {1, 1}}, 0);
        QVERIFY(invented && invented->returned && !invented->exactness);
        QVERIFY(!magnified(variant("sb:published"), {{2, 1}, {2, -1}}, {{0, 0}, {2, 2}}, 1));
        QVERIFY(!magnified(variant("md"), {{5, 5}, {6, 6}}, {{0, 0}, {2, 2}}, 0));
    }

    void theLatticeIsEveryNumber()
    {
        const double ulp = std::nextafter(100., 200.) - 100;
        const auto around = latticeBetween(100, -3 * ulp, 3 * ulp, Lattice::Double, 100);
        QCOMPARE(around.size(), std::size_t(7));
        for (std::size_t i = 0; i < 7; ++i)
            QCOMPARE(around[i], (double(i) - 3) * ulp);
        // Below a power of two they are twice as close.
        const auto at64 = latticeBetween(64, -2 * ulp, 2 * ulp, Lattice::Double, 100);
        QCOMPARE(at64.size(), std::size_t(7)); // ulp of 100 is that of 64
        QVERIFY(latticeBetween(100, -1, 1, Lattice::Double, 100).empty());
        const auto floats = latticeBetween(0.1, -2e-8, 2e-8, Lattice::Single, 100);
        QVERIFY(floats.size() >= 4 && floats.size() <= 6);
        for (const double offset : floats)
            QCOMPARE(double(float(0.1 + offset)) - 0.1, offset);
    }

    /// Far from the origin, where a double has room for nothing between two pixels of the drawing.
    void nothingJittersWhereUlpsAreLarge()
    {
        const Segment far{{1e15 + 1, 7}, {1e15 + 8, 1e15}};
        const Window window{{1e15, 10}, {1e15 + 100, 1e15 / 3}};
        const auto seen = magnified(variant("md"), far, window, 1);
        QVERIFY(seen && seen->exactness);
        MagnifierView view = usualView(*seen, {400, 300});
        const QImage one = picture(*seen, view);
        view.middle += QPointF(10, 0); // whole pixels: the same picture, moved
        const QImage moved = picture(*seen, view);
        int same = 0, all = 0;
        for (int y = 60; y < 280; ++y)
            for (int x = 120; x < 260; ++x, ++all)
                same += one.pixel(x, y) == moved.pixel(x + 10, y);
        QVERIFY2(same > all * 0.97, qPrintable(QString("%1 of %2").arg(same).arg(all)));
    }

    void zoomKeepsThePointUnderThePointer()
    {
        const auto seen = magnified(variant("md"), slanted, paper, 1);
        const MagnifierView view = usualView(*seen, {400, 300});
        const QPointF about(70, -30);
        const MagnifierView closer = zoomed(view, *seen, 3, about);
        const QPointF before = (about - view.middle) / view.pixelsPerUnit;
        const QPointF after = (about - closer.middle) / closer.pixelsPerUnit;
        QVERIFY(std::hypot(before.x() - after.x(), before.y() - after.y())
                <= 1e-12 * std::hypot(before.x(), before.y()));
        MagnifierView least = view, most = view;
        for (int i = 0; i < 200; ++i) {
            least = zoomed(least, *seen, 0.5, {});
            most = zoomed(most, *seen, 2, {});
        }
        QVERIFY(most.pixelsPerUnit * seen->ulp.x >= 100 && std::isfinite(most.pixelsPerUnit));
        QVERIFY(least.pixelsPerUnit * 200 >= 30); // the window is in sight
        for (const MagnifierView& any : {least, most, view})
            QVERIFY(!picture(*seen, any).isNull());
    }

    void theSmallestAndTheLargestNumbersArePainted()
    {
        const Window tiny{{0, 0}, {1e-320, 1e-320}}, huge{{-1e299, -1e299}, {1e299, 1e299}};
        for (const auto& [line, window] :
             {std::pair(Segment{{-1e-321, 5e-324}, {1e-320, 9e-321}}, tiny),
              std::pair(Segment{{-1e300, 3}, {1e300, 1e299}}, huge)})
            for (const int end : {0, 1}) {
                const auto seen = magnified(variant("exact"), line, window, end);
                QVERIFY(seen && seen->exactness);
                MagnifierView view = usualView(*seen, {400, 300});
                QVERIFY(std::isfinite(view.pixelsPerUnit) && view.pixelsPerUnit > 0);
                for (const double factor : {1e-3, 1e9})
                    QVERIFY(!picture(*seen, zoomed(view, *seen, factor, {10, 10})).isNull());
            }
    }

    void theAlgorithmsEndIsPaintedInItsColour()
    {
        const auto seen = magnified(variant("md"), slanted, paper, 1);
        MagnifierView view = usualView(*seen, {400, 300});
        const QImage image = picture(*seen, view);
        const QPointF end = QPointF(200, 150) + view.middle;
        QCOMPARE(image.pixelColor(end.toPoint()), QColor(0x1D63C9));
    }
};

} // namespace exactness_magnified_test

TEST_CLASS(exactness_magnified_test::MagnifiedTest, Gui)
#include "tests/app/exactness/magnified_test.moc"
