// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/label_places.h"

#include <QTest>

#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace overlays_label_places_test {

namespace {

const QRectF room(0, 0, 400, 300);

QPolygonF triangle(Random& random)
{
    QPolygonF polygon;
    for (int i = 0; i < 3; ++i)
        polygon << QPointF(random.between(0, 400), random.between(0, 300));
    return polygon;
}

} // namespace

class LabelPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void noLabelHidesAnotherOrLeavesTheRoom()
    {
        Random random(1);
        for (int i = 0; i < 200; ++i) {
            const QRectF handle(random.between(0, 390), random.between(0, 290), 9, 9);
            app::LabelPlaces places(room, {handle});
            std::vector<QRectF> given{handle};
            for (int k = 0; k < 30; ++k) {
                const QSizeF size(random.between(10, 120), 18);
                const QPointF at(random.between(0, 400), random.between(0, 300));
                const auto place = places.first(app::placesBeside(at, size, 6));
                if (!place)
                    continue;
                QVERIFY(room.contains(*place));
                QVERIFY(!place->contains(at));
                for (const QRectF& other : given)
                    QVERIFY(!place->intersects(other));
                given.push_back(*place);
            }
            QVERIFY(given.size() > 8);
        }
    }

    void avoidedPlacesAreUsedLast()
    {
        const QRectF letter(100, 100, 10, 10);
        const std::vector<QRectF> over{{95, 95, 40, 20}}, both{over[0], {200, 100, 40, 20}};
        QCOMPARE(app::LabelPlaces(room, {}, {letter}).first(both), std::optional(both[1]));
        QCOMPARE(app::LabelPlaces(room, {}, {letter}).first(over), std::optional(over[0]));
        QCOMPARE(app::LabelPlaces(room, {letter}).first(over), std::nullopt);
    }

    void shortLinesAreAvoided()
    {
        const std::vector<QLineF> lines{{10, 10, 20, 30}, {0, 0, 390, 290}, {500, 10, 520, 10}};
        const auto boxes = app::boxesOfShortLines(lines, room);
        QCOMPARE(boxes.size(), std::size_t(1));
        QVERIFY(boxes[0].contains(QRectF(10, 10, 10, 20)));
        const std::vector<QLineF> dense(5000, QLineF(10, 10, 20, 30));
        QVERIFY(app::boxesOfShortLines(dense, room).empty());
    }

    void anAreaKeepsItsLabelInside()
    {
        Random random(2);
        int found = 0;
        for (int i = 0; i < 500; ++i) {
            const QPolygonF area = triangle(random);
            for (const QRectF& place : app::placesInside(area, {30, 16})) {
                ++found;
                for (const QPointF& corner :
                     {place.topLeft(), place.topRight(), place.bottomLeft(), place.bottomRight()})
                    QVERIFY(area.containsPoint(corner, Qt::OddEvenFill)
                            || area.containsPoint(corner * 0.999 + 0.001 * place.center(),
                                                  Qt::OddEvenFill));
            }
        }
        QVERIFY(found > 500);
        QVERIFY(app::placesInside(QPolygonF(QRectF(0, 0, 20, 10)), {30, 16}).empty());
        QVERIFY(app::placesInside({}, {30, 16}).empty());
    }

    void labelsOfALineAreBesideIt()
    {
        for (const QRectF& place : app::placesAlong({0, 100, 400, 100}, {40, 16}, 3)) {
            QVERIFY(!place.intersects(QRectF(0, 99.5, 400, 1)));
            QVERIFY(place.left() >= 0 && place.right() <= 400);
        }
        QVERIFY(app::placesAlong({5, 5, 5, 5}, {40, 16}, 3).empty());
    }

    void hatchingStaysInsideAndMeetsTheNextAreas()
    {
        const QPolygonF left(QRectF(0, 0, 50, 100)), right(QRectF(50, 0, 50, 100));
        const auto lines = app::hatching(left, 10);
        QVERIFY(lines.size() >= 14);
        for (const QLineF& line : lines)
            for (const QPointF& p : {line.p1(), line.p2()}) {
                QVERIFY(QRectF(-1e-9, -1e-9, 50 + 2e-9, 100 + 2e-9).contains(p));
                QVERIFY(std::abs(std::remainder(p.x() + p.y(), 10)) < 1e-9);
            }
        QVERIFY(!app::hatching(right, 10).empty());
        QVERIFY(app::hatching({}, 10).empty());
    }
};

} // namespace overlays_label_places_test

TEST_CLASS(overlays_label_places_test::LabelPlacesTest, Core)
#include "tests/app/overlays/label_places_test.moc"
