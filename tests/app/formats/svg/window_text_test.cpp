// SPDX-License-Identifier: GPL-3.0-or-later
// The clip windows of a document in its file.
#include "app/document/recipe_outline.h"
#include "app/formats/loss_text.h"

#include <QTest>

#include <limits>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_window_text_test {

namespace {

app::Document with(const app::ClipWindows& windows)
{
    app::Document document;
    document.apply({.windows = windows});
    return document;
}

QByteArray metadataOf(const app::ClipWindows& windows)
{
    const QByteArray text = textOf(with(windows));
    const auto begin = text.indexOf("<metadata>");
    return begin < 0 ? "" : text.mid(begin, text.indexOf("\n", begin) - begin);
}

app::ClipWindows read(const QByteArray& elements)
{
    const auto result =
        readText(drawing("<metadata xmlns:c='urn:clearcut:1'>" + elements + "</metadata>"));
    return result ? result.value->document.windows() : app::ClipWindows{};
}

QString reportOn(const QByteArray& elements)
{
    return reportOf("<metadata xmlns:c='urn:clearcut:1'>" + elements + "</metadata>");
}

const app::RectangleShape box{{{0.1, -2}, {3, 40}}};

app::PathShape polygon(const std::vector<app::Point>& corners)
{
    app::Subpath ring{corners.front(), {}, true};
    for (std::size_t i = 1; i < corners.size(); ++i)
        ring.segments.push_back({corners[i]});
    return {app::Path({&ring, 1})};
}

app::PathShape circle()
{
    const app::EllipseRecipe recipe{{5, 6}, {2, 2}};
    const auto outline = app::outlineOf(app::Recipe(recipe));
    return {app::Path({&*outline, 1}), app::FillRule::EvenOdd, recipe};
}

} // namespace

class WindowTextTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsAreNotWritten()
    {
        QCOMPARE(metadataOf({}), "");
        QCOMPARE(metadataOf({{{.shape = box}}}),
                 "<metadata><clearcut:window xmin=\"0.1\" ymin=\"-2\" xmax=\"3\" ymax=\"40\"/>"
                 "</metadata>");
    }
    void aListOfAllKinds()
    {
        using app::WindowOperation;
        const app::ClipWindows windows{
            {{"<A>", box, WindowOperation::CutOut, false, app::Colour{1, 32, 255}},
             {{}, app::RectangleShape{{{1, 2}, {3, 4}}, 1.0 / 3}, WindowOperation::Intersect},
             {"B", polygon({{0, 0}, {9, 0.1}, {5, 1.0 / 3}})},
             {{}, app::PathShape{}},
             {.shape = box, .operation = WindowOperation::Replace}},
            app::Keep::Outside};
        QCOMPARE(
            metadataOf(windows),
            "<metadata><clearcut:window name=\"&lt;A>\" operation=\"cut-out\" visible=\"no\" "
            "colour=\"#0120ff\" keep=\"outside\" xmin=\"0.1\" ymin=\"-2\" xmax=\"3\" ymax=\"40\"/>"
            "<clearcut:window operation=\"intersect\" xmin=\"1\" ymin=\"2\" xmax=\"3\" "
            "ymax=\"4\" angle=\"0.3333333333333333rad\"/>"
            "<clearcut:window name=\"B\" d=\"M0 0L9 0.1L5 0.3333333333333333Z\"/>"
            "<clearcut:window d=\"\"/>"
            "<clearcut:window operation=\"replace\" xmin=\"0.1\" ymin=\"-2\" xmax=\"3\" "
            "ymax=\"40\"/></metadata>");
        const auto again = readText(textOf(with(windows)));
        QVERIFY(again && again.value->report.empty());
        QVERIFY(again.value->document.windows() == windows);
        QVERIFY(again.value->document.about() == app::About{});
    }
    void aCircleIsStillACircle()
    {
        const app::ClipWindows windows{{{.shape = circle()}}};
        QVERIFY(metadataOf(windows).endsWith(
            "rule=\"evenodd\" recipe=\"ellipse 5 6 2 2\"/></metadata>"));
        const auto again = readText(textOf(with(windows)));
        QVERIFY(again.value->document.windows() == windows);
        const auto lie = read("<c:window d='M0 0H9V9Z' recipe='ellipse 5 6 2 2'/>");
        QVERIFY(lie.list[0].shape == app::WindowShape(polygon({{0, 0}, {9, 0}, {9, 9}})));
    }
    void whatIsKeptIsKnownWithoutAWindowToo()
    {
        const app::ClipWindows outside{{}, app::Keep::Outside};
        QCOMPARE(metadataOf(outside), "<metadata><clearcut:window keep=\"outside\"/></metadata>");
        QVERIFY(read("<c:window keep='outside'/>") == outside);
        QCOMPARE(reportOn("<c:window keep='outside'/>"), "");
    }
    void anUnknownColourIsTheUsualOne()
    {
        const QByteArray window = "<c:window colour='reddish' xmin='.1' ymin='-2' xmax='3' "
                                  "ymax='40'/>";
        QVERIFY(!read(window).list[0].colour);
        QVERIFY2(reportOn(window).contains("unknown colour “reddish” of a clip window"),
                 qPrintable(reportOn(window)));
        QCOMPARE(
            read("<c:window colour='teal' xmin='0' ymin='0' xmax='3' ymax='4'/>").list[0].colour,
            std::optional(app::Colour{0, 128, 128}));
    }
    void aForeignFileHasNone()
    {
        QVERIFY(read("") == app::ClipWindows{});
        QVERIFY(read("<window xmin='0' ymin='0' xmax='1' ymax='1'/>") == app::ClipWindows{});
    }
    void oneOfAnEarlierVersion()
    {
        QVERIFY(read("<c:window xmin='.1' ymin='-2' xmax='3' ymax='4e1'/>")
                == (app::ClipWindows{{{.shape = box}}}));
    }
    void invalidOnesAreLeftOut()
    {
        const QByteArray good = "<c:window xmin='.1' ymin='-2' xmax='3' ymax='40'/>";
        const auto isLeftOut = [&](const QByteArray& attributes, const QString& one,
                                   const QString& two) {
            const QByteArray window = "<c:window " + attributes + "/>";
            QVERIFY2(read(window + good + window) == (app::ClipWindows{{{.shape = box}}}),
                     attributes);
            QCOMPARE(reportOn(window + good), one);
            QCOMPARE(reportOn(window + window), two);
        };
        for (const QByteArray bad :
             {"xmin='5' ymin='0' xmax='4' ymax='9'", "xmin='0' ymin='9' xmax='4' ymax='8'"})
            isLeftOut(bad, "1 inverted clip window", "2 inverted clip windows");
        for (const QByteArray bad :
             {"xmin='-1e308' ymin='0' xmax='1e308' ymax='9'", "xmin='x' ymin='0' xmax='1' ymax='9'",
              "xmin='0' ymin='0' xmax='1e400' ymax='9'", "xmin='0' ymin='0' xmax='nan' ymax='9'",
              "xmin='0'", "d='M0 0L1 x'", "d='M0 0L1e400 0'",
              "xmin='0' ymin='0' xmax='1' ymax='1' angle='90'"})
            isLeftOut(bad, "1 clip window with a missing or invalid number",
                      "2 clip windows with a missing or invalid number");
        isLeftOut("xmin='0' ymin='0' xmax='1' ymax='1' operation='melt'",
                  "1 clip window with the unknown operation “melt”",
                  "2 clip windows with the unknown operation “melt”");
        constexpr double infinite = std::numeric_limits<double>::infinity();
        QCOMPARE(metadataOf({{{.shape = app::RectangleShape{{{0, 0}, {1, infinite}}}},
                              {.shape = app::RectangleShape{{{0, 0}, {1, 1}}, infinite}},
                              {.shape = polygon({{0, infinite}, {1, 1}})},
                              {.shape = box}}}),
                 metadataOf({{{.shape = box}}}));
    }
    void aWindowThatIsLeftOutIsALoss()
    {
        const auto lossesOf = [](const QByteArray& window) {
            const auto result =
                readText(drawing("<metadata xmlns:c='urn:clearcut:1'>" + window + "</metadata>"));
            return result.value->report;
        };
        QCOMPARE(lossSentence(lossesOf("<c:window xmin='9' ymin='0' xmax='1' ymax='1'/>")),
                 "1 inverted clip window cannot be kept.");
        QCOMPARE(lossSentence(lossesOf("<c:window xmin='nan' ymin='0' xmax='1' ymax='1'/>")),
                 "1 clip window with a missing or invalid number cannot be kept.");
        QCOMPARE(lossLines(lossesOf("<c:window xmin='0' ymin='0' xmax='1' ymax='1' "
                                    "operation='subtract'/>")),
                 QStringList("Lost: 1 clip window with the unknown operation “subtract” (line 1); "
                             "the operations are add, cut-out, intersect and replace"));
    }
    // Whatever stands there, the file is read, and the line is told.
    void aBadColourRefusesNoFile()
    {
        for (const QByteArray colour :
             {"reddish", "rgb(1e999,0,0)", "rgb(nan,0,0)", "hsl(inf 1% 1%)", "#12"}) {
            const auto result = readText(drawing(
                "<metadata xmlns:c='urn:clearcut:1'>\n<c:window xmin='.1' ymin='-2' xmax='3' "
                "ymax='40' colour='"
                + colour + "'/></metadata>"));
            QVERIFY2(result, qPrintable(result.error));
            QCOMPARE(result.value->document.windows().list.size(), std::size_t(1));
            QVERIFY(!isLossy(*result.value));
            QCOMPARE(lossLines(result.value->report),
                     QStringList("Changed: 1 unknown colour “" + colour
                                 + "” of a clip window was replaced by the usual one (line 2)"));
        }
    }
    void unknownWordsAreNamed()
    {
        const QByteArray head = "<c:window xmin='.1' ymin='-2' xmax='3' ymax='40' ";
        const QByteArray windows = head + "keep='out' visible='false'/>" + head
                                   + "keep='inside' visible='yes'/>" + head + "visible='off'/>";
        QVERIFY(read(windows)
                == (app::ClipWindows{{{.shape = box}, {.shape = box}, {.shape = box}}}));
        QCOMPARE(reportOn(windows),
                 "1 unknown value “out” of “keep” (inside or outside) was read as inside; 2 "
                 "unknown values “false”, “off” of “visible” (yes or no) were read as yes");
        QByteArray many;
        for (const char* word : {"a", "b", "a", "%1", "d", "e"})
            many += head + "operation='" + word + "'/>";
        QCOMPARE(reportOn(many), "6 clip windows with the unknown operation “a”, “b”, “%1”, …");
        QVERIFY(reportOn(head + "operation='" + QByteArray(9'999, 'x') + "'/>").size() < 100);
    }
    void thereIsALimit()
    {
        const QByteArray window = "<c:window xmin='0' ymin='0' xmax='1' ymax='1'/>";
        QCOMPARE(read(window.repeated(1000)).list.size(), std::size_t(1000));
        QCOMPARE(reportOn(window.repeated(1000)), "");
        QCOMPARE(read(window.repeated(100'000)).list.size(), std::size_t(1000));
        QCOMPARE(reportOn(window.repeated(1001)), "1 clip window beyond the first 1,000");
    }
};

} // namespace formats_svg_window_text_test

TEST_CLASS(formats_svg_window_text_test::WindowTextTest, None)
#include "tests/app/formats/svg/window_text_test.moc"
