// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bar of a chosen clip window lies.
#include "app/base/text.h"
#include "app/view/capsule_place.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace view_capsule_place_test {

using namespace app;

namespace {

constexpr QSizeF capsule(400, 32);
constexpr QSizeF canvas(1000, 700);

CapsuleRoom around(const QRectF& box) { return {.canvas = canvas, .box = box}; }

} // namespace

class CapsulePlaceTest : public QObject {
    Q_OBJECT

private slots:
    void itsHomeIsReadFromASetting()
    {
        for (const CapsuleHomeInfo& each : capsuleHomes()) {
            QCOMPARE(&each - capsuleHomes().data(), std::ptrdiff_t(each.home));
            QCOMPARE(capsuleHomeOf(latin(each.key)), each.home);
        }
        for (const char* other : {"", "true", "garbage", "Bar", "2147483647"})
            QCOMPARE(capsuleHomeOf(other), CapsuleHome::AtObject);
    }
    void itIsBelowTheMiddle()
    {
        QCOMPARE(capsulePlace(capsule, around({300, 200, 400, 100})), QPointF(300, 313));
    }
    void itStaysInsideTheCanvas()
    {
        QCOMPARE(capsulePlace(capsule, around({-50, 200, 100, 100})), QPointF(8, 313));
        QCOMPARE(capsulePlace(capsule, around({950, 200, 100, 100})), QPointF(592, 313));
    }
    void itIsWhereThePointerWasLetGo()
    {
        CapsuleRoom room = around({300, 200, 400, 100});
        room.released = QPointF(310, 205);
        QCOMPARE(capsulePlace(capsule, room), QPointF(300, 155)); // above
        room.released = QPointF(310, 290);
        QCOMPARE(capsulePlace(capsule, room), QPointF(300, 313));
    }
    void withoutRoomBelowItIsAbove()
    {
        CapsuleRoom room = around({300, 560, 400, 100});
        room.released = QPointF(310, 655);
        QCOMPARE(capsulePlace(capsule, room), QPointF(300, 515));
    }
    void aLargeWindowHasItInside()
    {
        QCOMPARE(capsulePlace(capsule, around({100, 20, 800, 660})), QPointF(300, 636));
        // The lower edge is not seen: over that of the canvas.
        QCOMPARE(capsulePlace(capsule, around({100, 20, 800, 2000})), QPointF(300, 656));
    }
    void itCoversNoHandle()
    {
        CapsuleRoom room = around({300, 200, 300, 100});
        room.covered = {{640, 320, 10, 10}};                      // below, right of the middle
        QCOMPARE(capsulePlace(capsule, room), QPointF(200, 313)); // at the right side
        room.covered.push_back({310, 320, 200, 10});
        QCOMPARE(capsulePlace(capsule, room), QPointF(250, 155)); // above
    }
    void aWindowOffTheScreenHasNone()
    {
        QVERIFY(!capsulePlace(capsule, around({1200, 200, 100, 100})));
        QVERIFY(!capsulePlace(capsule, around({-90, 200, 100, 100}))); // but for a handle
        QVERIFY(capsulePlace(capsule, around({-80, 200, 100, 100})));
        QVERIFY(!capsulePlace({1100, 32}, around({300, 200, 100, 100}))); // the canvas is narrow
        QVERIFY(!capsulePlace(capsule, around({})));
    }
    void wherever()
    {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> place(-300, 1300), side(0, 500);
        std::size_t found = 0;
        for (int i = 0; i < 20'000; ++i) {
            CapsuleRoom room = around({place(random), place(random), side(random), side(random)});
            for (int k = 0; k < 3; ++k)
                room.covered.push_back({place(random), place(random), 100, 20});
            if (i % 2)
                room.released = QPointF(place(random), place(random));
            const auto at = capsulePlace(capsule, room);
            if (!at)
                continue;
            ++found;
            const QRectF lies(*at, capsule);
            QVERIFY(QRectF(QPointF(), canvas).contains(lies));
            for (const QRectF& covered : room.covered)
                QVERIFY(!lies.intersects(covered));
        }
        QVERIFY(found > 5'000 && found < 19'000);
    }
};

} // namespace view_capsule_place_test

TEST_CLASS(view_capsule_place_test::CapsulePlaceTest, None)
#include "tests/app/view/capsule_place_test.moc"
