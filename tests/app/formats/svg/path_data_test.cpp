// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/path_data.h"

#include <QTest>

#include <cmath>

#include "tests/test_class.h"

namespace formats_svg_path_data_test {

namespace {

// Compact text of an outline: "M0,0 L1,1 C... Z".
QString text(const app::svg::Outline& outline)
{
    QString result;
    const auto add = [&](const app::Point& p) {
        const auto number = [](double x) {
            return QString::number(std::round(x * 1e6) / 1e6 + 0.0);
        };
        result += number(p.x) + ',' + number(p.y) + ' ';
    };
    for (const app::Subpath& path : outline.paths) {
        result += 'M';
        add(path.start);
        for (const app::PathSegment& segment : path.segments) {
            result += segment.curved ? 'C' : 'L';
            if (segment.curved) {
                add(segment.control1);
                add(segment.control2);
            }
            add(segment.to);
        }
        if (path.closed)
            result += "Z ";
    }
    return result.trimmed() + (outline.damaged ? " damaged" : "");
}

QString drawn(const char* data) { return text(app::svg::parsePathData(data)); }

} // namespace

class PathDataTest : public QObject {
    Q_OBJECT

private slots:
    void grammar_data()
    {
        QTest::addColumn<QString>("data");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* data, const char* expected) {
            QTest::newRow(data) << QString(data) << QString(expected);
        };
        row("M0 0L1 1", "M0,0 L1,1");
        row("M 0,0 1,1 2,0", "M0,0 L1,1 L2,0");
        row("m1 1 1 1 1 0", "M1,1 L2,2 L3,2");
        row("M0 0h5v5H1V1", "M0,0 L5,0 L5,5 L1,5 L1,1");
        row("M0 0h5 5-3", "M0,0 L5,0 L10,0 L7,0");
        row("M1.5.5-.5-.5", "M1.5,0.5 L-0.5,-0.5");
        row("M1e1 1E-1L+2+3", "M10,0.1 L2,3");
        row("M0 0L4 0 4 4zl1 1", "M0,0 L4,0 L4,4 Z M0,0 L1,1");
        row("M1 1l2 0 0 2zm5 5l1 0", "M1,1 L3,1 L3,3 Z M6,6 L7,6");
        row("M0 0C1 2 3 4 5 6", "M0,0 C1,2 3,4 5,6");
        row("M1 1c1 2 3 4 5 6s1 1 2 2", "M1,1 C2,3 4,5 6,7 C8,9 7,8 8,9");
        row("M0 0S1 1 2 0", "M0,0 C0,0 1,1 2,0");
        row("M0 0Q3 3 6 0", "M0,0 C2,2 4,2 6,0");
        row("M0 0q3 3 6 0t6 0", "M0,0 C2,2 4,2 6,0 C8,-2 10,-2 12,0");
        row("M0 0t6 0", "M0,0 C0,0 2,0 6,0");
        row("M0 0L5 5M9 9", "M0,0 L5,5");
        row("M9 9", "");
        row("", "");
        row("none", "");
        row("M3 3L3 3", "M3,3");
        row("M3 3z", "M3,3 Z");
        row("  M\n0\t0 , 1 1", "M0,0 L1,1");
        row("M0 0A5 5 0 0 1 0 0", "");
        row("M0 0A0 5 0 0 1 4 0", "M0,0 L4,0");
        row("L1 1", " damaged");
        row("M0 0L1 1X2 2L3 3", "M0,0 L1,1 damaged");
        row("M0 0L1 1 2", "M0,0 L1,1 damaged");
        row("M0 0C1 1 2 2 3", " damaged");
        row("M0 0L1 1z2 2", "M0,0 L1,1 Z damaged");
        row("M0 0A5 5 0 2 1 4 0", " damaged");
        row("M0 0L1#1", " damaged");
    }
    void grammar()
    {
        QFETCH(QString, data);
        QFETCH(QString, expected);
        QCOMPARE(drawn(data.toUtf8()).trimmed(), expected.trimmed());
    }

    void arcFlagsNeedNoSeparators()
    {
        QCOMPARE(drawn("M0 0a5 5 0 0110 0"), drawn("M0,0 A 5,5 0 0,1 10,0"));
        QCOMPARE(drawn("M0 0a5 5 0 1010-.5 5 5 0 013 3"),
                 drawn("M0 0a5 5 0 1 0 10 -.5 a 5 5 0 0 1 3 3"));
    }

    // The points of the cubics lie on the circle, and the arc goes the way the flags say.
    void arcsLieOnTheirCircle_data()
    {
        QTest::addColumn<bool>("large");
        QTest::addColumn<bool>("positive");
        for (const bool large : {false, true})
            for (const bool positive : {false, true})
                QTest::addRow("%d%d", large, positive) << large << positive;
    }
    void arcsLieOnTheirCircle()
    {
        QFETCH(bool, large);
        QFETCH(bool, positive);
        const auto data =
            QStringLiteral("M3 0A3 3 0 %1 %2 0 3").arg(large).arg(positive).toStdString();
        const auto outline = app::svg::parsePathData(data);
        const app::Subpath& path = outline.paths.at(0);
        const app::Point centre = large == positive ? app::Point{3, 3} : app::Point{0, 0};
        QCOMPARE(int(path.segments.size()), large ? 3 : 1);
        app::Point from = path.start;
        double turned = 0;
        for (const app::PathSegment& c : path.segments) {
            const app::Point middle = (from + 3.0 * c.control1 + 3.0 * c.control2 + c.to) / 8.0;
            for (const app::Point& p : {middle, c.to})
                QVERIFY(std::abs(std::hypot(p.x - centre.x, p.y - centre.y) - 3) < 3 * 3e-4);
            const app::Point a = from - centre, b = c.to - centre;
            turned += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
            from = c.to;
        }
        QCOMPARE(from, (app::Point{0, 3}));
        QCOMPARE(turned > 0, positive);
        QCOMPARE(std::abs(turned) > 3.15, large);
    }

    void radiiTooSmallAreScaledUp()
    {
        const auto outline = app::svg::parsePathData("M0 0A1 2 0 0 1 10 0");
        double top = 0;
        app::Point from{};
        for (const app::PathSegment& c : outline.paths.at(0).segments) {
            top = std::min(top, ((from + 3.0 * c.control1 + 3.0 * c.control2 + c.to) / 8.0).y);
            top = std::min(top, c.to.y);
            from = c.to;
        }
        QVERIFY(std::abs(top + 10) < 0.01); // half the chord is 5, the other radius twice as long
    }

    void points()
    {
        using app::svg::Ending;
        QCOMPARE(text(app::svg::parsePoints("0,0 1,1,2 2", Ending::Open)), "M0,0 L1,1 L2,2");
        QCOMPARE(text(app::svg::parsePoints("0-1-2-3", Ending::Closed)), "M0,-1 L-2,-3 Z");
        QCOMPARE(text(app::svg::parsePoints("0 0 1 1 2", Ending::Open)), "M0,0 L1,1 damaged");
        QCOMPARE(text(app::svg::parsePoints("", Ending::Closed)), "");
        QCOMPARE(text(app::svg::parsePoints("5 5", Ending::Open)), "");
    }

    void tinyNumbersAreZeroAndHugeOnesRefused()
    {
        QCOMPARE(drawn("M1e-400 0.0L1 1"), "M0,0 L1,1");
        for (const char* bad :
             {"M1e400 0L1 1", "M0 0L-1e999 0", "M0 0Lnan 0", "M0 0L-Infinity 0", "M0 0h1e301"}) {
            bool refused = false;
            try {
                app::svg::parsePathData(bad);
            } catch (...) {
                refused = true;
            }
            QVERIFY2(refused, bad);
        }
    }
};

} // namespace formats_svg_path_data_test

TEST_CLASS(formats_svg_path_data_test::PathDataTest, None)
#include "tests/app/formats/svg/path_data_test.moc"
