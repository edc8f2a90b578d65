// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <set>

#include "tests/test_class.h"

namespace drawing_transformation_test {

using namespace app;

class TransformationTest : public QObject {
    Q_OBJECT

    /// A gesture about (100, 50) that began with the pointer at (110, 50).
    struct Gesture {
        explicit Gesture(const char* key, Along along = Along::Both)
            : kind(*findTransformation(key)), axis(along),
              readout({&kind.measure(axis), {{100, 50}, {110, 50}}, {7, 9}, {Unit::Mm, 1}})
        {
        }
        AffineMap map(const char* typed, const Point& pointer, double times = 1)
        {
            readout.type(QString::fromUtf8(typed));
            const bool taken = readout.accept(pointer);
            return taken ? kind.map(readout.gauge().start, readout.result(pointer), axis, times)
                         : AffineMap{{0, 0}, {0, 0}};
        }
        const Transformation& kind;
        Along axis;
        Readout readout;
    };
    static bool near(const Point& a, const Point& b) { return glm::distance(a, b) < 1e-9; }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyKindHasItsKeyAndItsTexts()
    {
        std::set<QChar> letters;
        for (const Transformation& kind : transformations()) {
            QVERIFY(letters.insert(kind.letter).second);
            QVERIFY(findTransformation(kind.key) == &kind);
            QVERIFY(kind.needs.endsWith(u'.') && !kind.undoText.isEmpty());
        }
        QVERIFY(!findTransformation("nothing"));
    }
    void skewHasStepsOf15Degrees()
    {
        // About (100, 50), from (110, 70): the height is −20.
        const GestureStart start{{100, 50}, {110, 70}};
        for (const Along axis : {Along::X, Along::Y}) {
            const GestureMeasure& measure = findTransformation("skew")->measure(axis);
            for (double way = -300; way <= 300; way += 7) {
                const Point to = start.pointer + (axis == Along::X ? Point(way, 0) : Point(0, way));
                const double angle = measure.values(start, measure.toStep(start, to))[0];
                QVERIFY(std::abs(std::remainder(angle, 15)) < 1e-9 && std::abs(angle) < 80);
                const double free = measure.values(start, to)[0];
                QVERIFY(std::abs(angle - free) < 7.5 + 1e-9 || std::abs(free) > 75);
            }
        }
    }
    void typedNumbersHoldExactly()
    {
        const Point p(120, 50);
        QVERIFY(
            near(Gesture("rotate").map("30", {1, 2})(p), {100 + 20 * std::sqrt(0.75), 50 - 10}));
        QCOMPARE(Gesture("rotate").map("90", {1, 2})(p), Point(100, 30));
        QCOMPARE(Gesture("scale").map("2", {1, 2})(Point(103, 54)), Point(106, 58));
        QCOMPARE(Gesture("scale").map("150%", {1, 2})(p), Point(130, 50));
        QCOMPARE(Gesture("scale", Along::X).map("-1", {1, 2})(Point(103, 54)), Point(97, 54));
        QVERIFY(near(Gesture("skew").map("45", {1, 2})(Point(100, 40)), {110, 40}));
        QVERIFY(near(Gesture("skew", Along::Y).map("45", {1, 2})(Point(110, 50)), {110, 40}));
        QCOMPARE(Gesture("move").map("10,20", {1, 2})(p), Point(130, 70));
        QCOMPARE(Gesture("move").map("#10,20", {1, 2})(Point(100, 50)), Point(17, 29));
        QCOMPARE(Gesture("move", Along::Y).map("-5", {1, 2})(p), Point(120, 45));
    }
    void pointerDecidesWhatIsNotTyped()
    {
        QVERIFY(near(Gesture("rotate").map("", {100, 40})(Point(120, 50)), {100, 30}));
        QCOMPARE(Gesture("scale").map("", {125, 50})(Point(102, 50)), Point(105, 50));
        QCOMPARE(Gesture("scale").map("", {90, 50})(Point(102, 50)), Point(98, 50));
        QCOMPARE(Gesture("move", Along::X).map("", {130, 99})(Point(0, 0)), Point(30, 0));
        QCOMPARE(Gesture("scale", Along::Y).map("", {500, 99})(Point(0, 0)), Point(0, 0));
    }
    void stepsOfAnAngle()
    {
        const Gesture turn("rotate");
        const Point stepped = turn.readout.toStep({103, 44}); // 63.4°
        QVERIFY(std::abs(turn.readout.result(stepped).numbers[0] - 60) < 1e-9);
        const Gesture scale("scale");
        QCOMPARE(scale.readout.toStep({103, 44}), Point(103, 44));
    }
    void timesRepeatTheStepAndPartsDivideIt()
    {
        QCOMPARE(Gesture("move").map("10,20", {}, 3)(Point(0, 0)), Point(30, 60));
        QCOMPARE(Gesture("rotate").map("30", {}, 3)(Point(110, 50)), Point(100, 40));
        QCOMPARE(Gesture("scale").map("2", {}, 3)(Point(101, 50)), Point(108, 50));
        QCOMPARE(Gesture("move").map("10,20", {}, 0.5)(Point(0, 0)), Point(5, 10));
    }
    void whatHasNoMeaningIsRefused_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("typed");
        QTest::newRow("a scale of 0") << "scale"
                                      << "0";
        QTest::newRow("a point as angle") << "rotate"
                                          << "10,20";
        QTest::newRow("a polar point as scale") << "scale"
                                                << "30<45";
        QTest::newRow("a skew of 90°") << "skew"
                                       << "90";
        QTest::newRow("copies without copying") << "rotate"
                                                << "5x";
        QTest::newRow("letters") << "scale"
                                 << "abc";
        QTest::newRow("a unit as angle") << "rotate"
                                         << "3mm";
    }
    void whatHasNoMeaningIsRefused()
    {
        QFETCH(QString, key);
        QFETCH(QString, typed);
        Gesture gesture(qPrintable(key));
        gesture.readout.type(typed);
        QVERIFY(!gesture.readout.accept({1, 2}));
        QVERIFY2(gesture.readout.error().endsWith(u'.'), qPrintable(gesture.readout.error()));
    }
    void copiesAreRepeatedOrDivided()
    {
        Gauge gauge = Gesture("move").readout.gauge();
        gauge.repeats = true;
        Readout readout(gauge);
        readout.type("5x");
        QVERIFY(readout.accept({110, 50}));
        QCOMPARE(*readout.result({110, 50}).repeat, (RepeatEntry{5, RepeatEntry::How::Times}));
        readout.type("4/");
        QVERIFY(readout.accept({110, 50}));
        QCOMPARE(*readout.result({110, 50}).repeat, (RepeatEntry{4, RepeatEntry::How::Parts}));
        for (const char* wrong : {"0x", "1.5x", "-2/", "99999x"}) {
            readout.type(QString::fromLatin1(wrong));
            QVERIFY2(!readout.accept({110, 50}), wrong);
        }
    }
};

} // namespace drawing_transformation_test

TEST_CLASS(drawing_transformation_test::TransformationTest, None)
#include "tests/app/drawing/transformation_test.moc"
