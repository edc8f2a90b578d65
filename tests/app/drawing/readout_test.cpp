// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/direction.h"
#include "app/drawing/readout.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace drawing_readout_test {

using namespace app;

class ReadoutTest : public QObject {
    Q_OBJECT

    static Readout readout(const GestureMeasure& measure, const Point& from = {100, 50})
    {
        return Readout({&measure, {from}, {7, 9}, {Unit::Mm, 1}});
    }
    static double distance(const Point& a, const Point& b) { return glm::distance(a, b); }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void pointerDecidesWhatIsNotTyped()
    {
        for (const GestureMeasure* measure : {&lengthAndAngle(), &widthAndHeight(), &position()})
            QCOMPARE(readout(*measure).end({12.25, -3.5}), Point(12.25, -3.5));
    }
    void typedLengthHoldsInThePointersDirection()
    {
        Readout line = readout(lengthAndAngle());
        line.type("3450");
        QCOMPARE(line.end({300, 50}), Point(3550, 50)); // exactly, along an axis
        QCOMPARE(line.end({100, 40}), Point(100, -3400));
        QVERIFY(distance(line.end({103, 54}), {100 + 3450 * 0.6, 50 + 3450 * 0.8}) < 1e-9);
        QCOMPARE(line.end({100, 50}), Point(3550, 50)); // no direction: to the right
    }
    void tabLocksANumberWhichThenNeverChanges()
    {
        Readout line = readout(lengthAndAngle());
        line.type("3450");
        QVERIFY(line.lock());
        QCOMPARE(line.active(), std::size_t(1));
        QVERIFY(line.state(0) == Readout::State::Locked);
        line.type("90");
        QVERIFY(line.accept({}));
        for (const Point& pointer : {Point(0, 0), Point(1e6, -4), Point(100, 50)})
            QCOMPARE(line.end(pointer), Point(100, 50 - 3450));
        line.release();
        QVERIFY(std::abs(distance(line.end({-20, 18}), {100, 50}) - 3450) < 1e-9);
        QCOMPARE(line.number(0, line.end({-20, 18})), "3450.00\u00a0mm");
    }
    void coordinatesOfANodeAreAbsoluteAndRelativeOnesCountFromIt()
    {
        Gauge gauge{&position(), {{7, 9}}, {7, 9}, {Unit::Mm, 1}};
        gauge.relativeTo = Point(100, 50);
        gauge.aim = GestureEnd{{100, 50}, {93, 41}};
        Readout node(gauge);
        QCOMPARE(node.end({1, 1}), Point(100, 50)); // the pointer does not matter
        for (const auto& [text, end] : {std::pair{"10,20", Point(17, 29)},
                                        {"#10,20", {17, 29}},
                                        {"@10,20", {110, 70}},
                                        {"30<90", {100, 20}},
                                        {"10", {17, 50}}}) {
            node.type(text);
            QVERIFY2(distance(node.end({1, 1}), end) < 1e-12, text);
        }
        gauge.relativeTo = Point(17, 50);
        QVERIFY(!node.follow(gauge)); // another node: what is typed does not hold for it
    }
    void heldAngleKeepsTheEndOnItsRay()
    {
        Readout line = readout(lengthAndAngle());
        line.type("<30");
        const Point end = line.end({200, 0});
        QVERIFY(std::abs(degreesOf(end - Point(100, 50)) - 30) < 1e-12);
        QCOMPARE(line.end({0, 100}), Point(100, 50)); // the pointer is behind the start
        QVERIFY(line.lock());
        QVERIFY(line.state(0) == Readout::State::Free);
        QVERIFY(line.state(1) == Readout::State::Locked);
        QCOMPARE(line.active(), std::size_t(0)); // the length is free
        QVERIFY(line.typed(0).isEmpty());
    }
    void pointsAreRelativeAbsoluteOrPolar()
    {
        Readout line = readout(lengthAndAngle());
        const auto end = [&](const char* text) {
            line.type(QString::fromUtf8(text));
            return line.accept({0, 0}) ? line.end({0, 0}) : Point(NAN, NAN);
        };
        QCOMPARE(end("10,20"), Point(110, 70));
        QCOMPARE(end("@10,20"), Point(110, 70));
        QCOMPARE(end("#10,20"), Point(17, 29));
        QCOMPARE(end("10;-20"), Point(110, 30));
        QCOMPARE(end("30<90"), Point(100, 20));
        QCOMPARE(end("#30<0"), Point(37, 9));
        QCOMPARE(end("1in+4.6 , (2+3)*2"), Point(130, 60));
        Readout first = readout(position(), {7, 9});
        first.type("10,20");
        QCOMPARE(first.end({0, 0}), Point(17, 29)); // a first point
    }
    void decimalCommaSeparatesBySemicolonOnly()
    {
        const QLocale german(QLocale::German);
        const auto number = readEntry("10,5", Quantity::Length, {Unit::Mm, 1}, german);
        QVERIFY(number && std::get<NumberEntry>(*number.value).value == 10.5);
        const auto point = readEntry("10,5;-3", Quantity::Length, {Unit::Mm, 1}, german);
        QVERIFY(point && std::get<PointEntry>(*point.value).point == Point(10.5, -3));
    }
    void widthAndHeightGoToThePointersSide()
    {
        Readout box = readout(widthAndHeight());
        box.type("20");
        QCOMPARE(box.end({0, 90}), Point(80, 90));
        QVERIFY(box.lock());
        box.type("30mm");
        QCOMPARE(box.end({0, 0}), Point(80, 20));
        QCOMPARE(box.end({500, 500}), Point(120, 80));
        box.type("-30");
        QCOMPARE(box.end({500, 500}), Point(120, 20));
    }
    void squaresAndCentresKeepTheHeldSide()
    {
        Readout square = readout(widthAndHeight(Proportion::Square));
        square.type("20");
        QCOMPARE(square.end({0, 500}), Point(80, 70));
        Readout centred = readout(widthAndHeight(Proportion::Free, Anchor::Centre));
        centred.type("20");
        QCOMPARE(centred.end({0, 60}), Point(90, 60));
        QCOMPARE(centred.number(0, {90, 60}), "20.00\u00a0mm");
        QCOMPARE(centred.number(1, {90, 60}), "20.00\u00a0mm");
    }
    void correctionKeepsWhatIsNotTyped()
    {
        Gauge gauge = readout(lengthAndAngle()).gauge();
        gauge.aim = GestureEnd{{160, 50}, {60, 0}};
        Readout line(gauge);
        QCOMPARE(line.end({3, 4}), Point(160, 50));
        line.type("<90");
        QCOMPARE(line.end({3, 4}), Point(100, -10));
        line.type("20");
        QCOMPARE(line.end({3, 4}), Point(120, 50));
        gauge.measure = &widthAndHeight(Proportion::Square);
        gauge.aim = GestureEnd{{160, 110}, {60, 60}};
        Readout square(gauge);
        square.activate(1);
        square.type("10");
        QCOMPARE(square.end({3, 4}), Point(110, 60));
    }
    void lengthFromTheMiddleIsTheWholeLength()
    {
        Readout line = readout(lengthAndAngle(Anchor::Centre));
        QCOMPARE(line.number(0, {110, 50}), "20.00\u00a0mm");
        line.type("30");
        QCOMPARE(line.end({90, 50}), Point(85, 50));
        line.type("30<90");
        QCOMPARE(line.end({90, 50}), Point(100, 35));
        line.type("<0");
        QCOMPARE(line.end({130, 90}), Point(130, 50));
    }
    void directionsAndPointsAreTold()
    {
        Readout line = readout(lengthAndAngle());
        for (const auto& [typed, direction, point] : {std::tuple{"<45", true, false},
                                                      {"3<45", false, false},
                                                      {"45", false, false},
                                                      {"10,20", false, true},
                                                      {"@10,20", false, false},
                                                      {"10,", false, false}}) {
            line.type(typed);
            QCOMPARE(line.typesDirection(), direction);
            QCOMPARE(line.typesPoint(), point);
        }
        line.type("7");
        QVERIFY(line.lock());
        line.type("<45");
        QVERIFY(!line.typesDirection()); // the length is locked
    }
    void sameGestureKeepsWhatIsTyped()
    {
        Readout box = readout(widthAndHeight());
        box.type("20");
        Gauge gauge = box.gauge();
        gauge.measure = &widthAndHeight(Proportion::Square);
        QVERIFY(box.follow(gauge));
        QCOMPARE(box.end({500, 500}), Point(120, 70));
        gauge.aim = GestureEnd{{0, 0}, {}};
        QVERIFY(box.follow(gauge));
        QCOMPARE(box.end({500, 500}), Point(80, 30));
        gauge.start.from = {1, 1};
        QVERIFY(!box.follow(gauge));
        gauge = box.gauge();
        gauge.measure = &lengthAndAngle();
        QVERIFY(!box.follow(gauge));
    }
    void whatIsNoNumberIsRefusedAndHoldsNothing_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text : {"abc", "nan", "inf", "1e400", "--", "10,20,30", "30<", "<x", "#5",
                                 "@", "1/0", "10mm*3mm", "99999999999"})
            QTest::addRow("%s", text) << QString::fromLatin1(text);
    }
    void whatIsNoNumberIsRefusedAndHoldsNothing()
    {
        QFETCH(QString, text);
        Readout line = readout(lengthAndAngle());
        line.type(text);
        QCOMPARE(line.end({3, 4}), Point(3, 4));
        QVERIFY(line.error().isEmpty()); // typing is not finished
        QVERIFY(!line.lock());
        QVERIFY(!line.accept({}));
        QVERIFY2(line.error().endsWith(u'.'), qPrintable(line.error()));
        line.type("5");
        QVERIFY(line.accept({}) && line.error().isEmpty());
    }
    void lengthsOfZeroAreRefused()
    {
        const auto errorOf = [](const GestureMeasure& measure, const char* typed) {
            Readout numbers = readout(measure);
            numbers.type(QString::fromUtf8(typed));
            return numbers.accept({130, 90}) ? QString() : numbers.error();
        };
        QCOMPARE(errorOf(lengthAndAngle(), "0"), "Length must not be 0.");
        QCOMPARE(errorOf(lengthAndAngle(), "0,0"), "Length must not be 0.");
        QCOMPARE(errorOf(widthAndHeight(), "0"), "Width must not be 0.");
        QCOMPARE(errorOf(widthAndHeight(), "@10,0"), "Height must not be 0.");
        QCOMPARE(errorOf(position(), "0,0"), QString());
        Readout line = readout(lengthAndAngle());
        line.type("0");
        QVERIFY(!line.lock());
        line.activate(1);
        line.type("0");
        QVERIFY(line.lock()); // an angle
    }
    void lockedPointIsGivenBackAsAWhole()
    {
        Readout line = readout(lengthAndAngle());
        line.type("3,4");
        QVERIFY(line.lock());
        QCOMPARE(line.end({0, 0}), Point(103, 54));
        QVERIFY(line.state(0) == Readout::State::Locked && line.state(1) == line.state(0));
        line.release();
        QCOMPARE(line.end({1, 2}), Point(1, 2));
        QVERIFY(!line.isLocked());
        QCOMPARE(line.end({3, 4}), Point(3, 4));
    }
    void directionsAreExactWhereTheyCanBe()
    {
        QCOMPARE(directionOf(0), Point(1, 0));
        QCOMPARE(directionOf(90), Point(0, -1));
        QCOMPARE(directionOf(180), Point(-1, 0));
        QCOMPARE(directionOf(-450), Point(0, 1));
        QCOMPARE(directionOf(60).x, 0.5);
        QCOMPARE(directionOf(30).y, -0.5);
        for (int degrees = -179; degrees <= 180; ++degrees)
            QVERIFY(std::abs(degreesOf(directionOf(degrees)) - degrees) < 1e-12);
        QCOMPARE(turnedToStep({1, 2}, {11, 2.5}), Point(11, 2));
    }
};

} // namespace drawing_readout_test

TEST_CLASS(drawing_readout_test::ReadoutTest, Core)
#include "tests/app/drawing/readout_test.moc"
