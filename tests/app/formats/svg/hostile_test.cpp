// SPDX-License-Identifier: GPL-3.0-or-later
// Bad files end in one clear sentence, soon, and without much memory.
#include "app/formats/loss_text.h"

#include <QBuffer>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace formats_svg_hostile_test {

namespace {

QString error(const QByteArray& text)
{
    const auto result = readText(text);
    return result ? QStringLiteral("(no error)") : result.error;
}

/// A file that says it is larger than any memory.
struct HugeFile : QBuffer {
    explicit HugeFile(QByteArray& content) : QBuffer(&content) { open(ReadOnly); }
    qint64 size() const override { return 1'000'000'000'000'000; }
};

QByteArray doublingUses(int levels, int width)
{
    QByteArray defs = "<defs><path id='u0' d='M0 0h1'/>";
    for (int i = 1; i <= levels; ++i) {
        defs += "<g id='u" + QByteArray::number(i) + "'>";
        defs += ("<use xlink:href='#u" + QByteArray::number(i - 1) + "'/>").repeated(width);
        defs += "</g>\n";
    }
    return drawing(defs + "</defs><use xlink:href='#u" + QByteArray::number(levels) + "'/>");
}

long peakMegabytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

} // namespace

class HostileTest : public QObject {
    Q_OBJECT

private slots:
    // NOLINTNEXTLINE(readability-function-size): a table, a row for each sentence
    void sentences_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("expected"); // how the sentence begins
        const auto row = [](const char* name, const QByteArray& text, const char* expected) {
            QTest::newRow(name) << text << QString(expected);
        };
        row("empty", "", "it is empty.");
        row("blank", " \n ", "it is empty.");
        row("text", "Hello\nworld", "it is not an SVG drawing (");
        row("binary", QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
            "it is not an SVG drawing (");
        row("zeros", QByteArray(100'000, '\0'), "it is not an SVG drawing (");
        row("html", "<html><body/></html>",
            "it is not an SVG drawing; its first element is <html>.");
        row("compressed", QByteArray("\x1f\x8b\x08\0", 4), "it is compressed (.svgz) and damaged");
        row("truncated", "<svg xmlns='http://www.w3.org/2000/svg'>\n<g>\n<path d='M0 0",
            "line 3 is incomplete: the file ends too early.");
        row("truncated after an element", "<svg xmlns='http://www.w3.org/2000/svg'>\n<g/>\n",
            "line 3 is incomplete: the file ends too early.");
        row("tags cross", drawing("\n<g>\n</a>"), "line 3 is not correct XML (");
        row("two roots", "<svg/><svg/>", "line 1 is not correct XML (");
        row("bad encoding", drawing("<g id='\xff\xfe'/>"), "line 1 is not correct XML (");
        row("undeclared entity", drawing("&x;"), "line 1 is not correct XML (");
        row("nan", drawing("\n<line x1='NaN'/>"),
            "line 2 has NaN where a finite number should be.");
        row("infinite", drawing("\n\n<circle r='-inf'/>"),
            "line 3 has -inf where a finite number should be.");
        row("1e400", drawing("<path d='M0 0L1e400 0'/>"),
            "line 1 has 1e400 where a finite number should be.");
        row("1e400 in a transform", drawing("<g transform='scale(1e400)'/>"),
            "line 1 has 1e400 where a finite number should be.");
        row("transform overflows",
            drawing("<g transform='scale(1e200)'><g transform='scale(1e200)'>\n<path d='M1 1L2 "
                    "2'/></g></g>"),
            "line 2 has a coordinate that is too large to be drawn.");
        row("relative overflow",
            drawing("<path d='M9e299 0" + QByteArray("h9e299").repeated(20) + "'/>"),
            "line 1 has a coordinate that is too large to be drawn.");
        row("stroke overflows",
            drawing("<g transform='scale(1e100)'><path d='M1 1L2 2' stroke-width='1e290'/></g>"),
            "line 1 has a stroke that is too large to be drawn.");
        row("deep",
            "<svg>" + QByteArray("<g>").repeated(1'000'000) + QByteArray("</g>").repeated(1'000'000)
                + "</svg>",
            "line 1 nests elements deeper than 520; ungroup some of them.");
        row("deep without end", "<svg>" + QByteArray("<g>").repeated(100'000),
            "line 1 nests elements deeper than 520");
        row("deep groups",
            "<svg>" + QByteArray("<g id='a'>").repeated(1'000'000)
                + QByteArray("</g>").repeated(1'000'000) + "</svg>",
            "line 1 nests elements deeper than 520; ungroup some of them.");
        row("curves of 10^4 chords",
            drawing(QByteArray("<path d='M0 0C1e14 1 -1e14 5 9 9'/>\n").repeated(2'000)),
            "line 1000 exceeds the limit of");
        row("use bomb of 10^6", doublingUses(6, 10), "line ");
        row("use bomb of 10^9", doublingUses(9, 10), "line ");
        row("use bomb of 2^400", doublingUses(400, 2), "line ");
    }
    void sentences()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, expected);
        QElapsedTimer timer;
        timer.start();
        const QString got = error(text);
        QVERIFY2(got.startsWith(expected), qPrintable(got));
        QVERIFY2(got.endsWith('.') && !got.contains('\n'), qPrintable(got));
        qInfo("%lld ms", timer.elapsed()); // what hangs is ended by ctest
    }

    // Only the element that would contain itself is left out.
    void aUseThatContainsItselfIsLeftOut_data()
    {
        QTest::addColumn<QByteArray>("elements");
        const QByteArray more = "<path d='M0 0h1'/>";
        QTest::newRow("itself") << "\n<use id='a' xlink:href='#a'/>" + more;
        QTest::newRow("its parent") << "<g id='a'>" + more + "\n<use xlink:href='#a'/></g>";
        QTest::newRow("each other") << "<defs><g id='a'><use xlink:href='#b'/></g>\n<g id='b'>"
                                           + more
                                           + "<use xlink:href='#a'/></g></defs><use href='#a'/>";
        QTest::newRow("in a clip path") << "<clipPath id='c'>\n<use id='u' href='#u'/></clipPath>"
                                               + more + "<path clip-path='url(#c)' d='M0 0h1'/>";
        QTest::newRow("around a box")
            << "<g id='a' style='transform:scale(1);transform-box:fill-box'>" + more
                   + "\n<use href='#a'/></g>";
    }
    void aUseThatContainsItselfIsLeftOut()
    {
        QFETCH(QByteArray, elements);
        const auto result = readText(drawing(elements));
        QVERIFY2(result, qPrintable(result.error));
        QVERIFY(!result.value->document.objects().empty());
        QVERIFY(isLossy(*result.value));
        QVERIFY(!result.value->report.empty());
    }
    void aUseThatContainsItselfIsTold()
    {
        const auto report = readText(drawing("\n<use id='a' xlink:href='#a'/>")).value->report;
        QCOMPARE(report.size(), std::size_t(1));
        QCOMPARE(report[0].what, "<use> that contains itself");
        QCOMPARE(report[0].line, 2);
    }

    void longUseChainsAreRefused()
    {
        QByteArray defs = "<path id='u0' d='M0 0h1'/>";
        for (int i = 1; i <= 5000; ++i)
            defs += "<use id='u" + QByteArray::number(i) + "' href='#u" + QByteArray::number(i - 1)
                    + "'/>";
        QVERIFY(error(drawing("<defs>" + defs + "</defs><use href='#u5000'/>"))
                    .contains("nests elements deeper"));
        QCOMPARE(error(drawing("<defs>" + defs + "</defs><use href='#u400'/>")), "(no error)");
    }

    void entityBombsAreRefused()
    {
        QByteArray bomb = "<!DOCTYPE svg [<!ENTITY e0 'ha'>";
        for (int i = 1; i <= 9; ++i)
            bomb += "<!ENTITY e" + QByteArray::number(i) + " '"
                    + ("&e" + QByteArray::number(i - 1) + ";").repeated(10) + "'>";
        QVERIFY(error(bomb + "]><svg><g id='&e9;'/></svg>").contains("is not correct XML"));
        QVERIFY(error(bomb + "]><svg><title>&e9;</title></svg>").contains("is not correct XML"));
    }

    void externalEntitiesAreNeverFetched()
    {
        QTemporaryDir folder;
        QFile secret(folder.filePath("secret.txt"));
        QVERIFY(secret.open(QIODevice::WriteOnly));
        secret.write("M 0 0 L 7 7");
        secret.close();
        const QByteArray doctype =
            "<!DOCTYPE svg [<!ENTITY x SYSTEM 'file://" + secret.fileName().toUtf8() + "'>]>";
        const auto inText = readText(doctype + drawing("<style>&x;</style><path d='M0 0L1 1'/>"));
        QVERIFY(!inText || !textOf(inText.value->document).contains("7"));
        const auto inAttribute = readText(doctype + drawing("<path d='&x;'/>"));
        QVERIFY(!inAttribute || inAttribute.value->document.objects().empty());
    }

    void entitiesOfTheFileAreExpanded()
    {
        const auto result =
            readText("<!DOCTYPE svg [<!ENTITY d 'M 0 0 L 7 7'>]>" + drawing("<path d='&d;'/>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document.objects().size(), 1u);
    }

    void damagedShapesAreKeptAsFarAsTheyAreClear()
    {
        QCOMPARE(reportOf("<path d='M0 0L1 1L'/>"), "1 part of a damaged shape");
        QCOMPARE(reportOf("<circle r='red'/>"), "1 part of a damaged shape");
        QCOMPARE(shapeOf("<path d='M0 0L1 1L'/>").paths.at(0).segments.size(), 1u);
    }

    void variablesCannotMultiply()
    {
        QByteArray style = "--v0:1,1,1,1,1,1,1,1,1,1;";
        for (int i = 1; i <= 9; ++i)
            style += "--v" + QByteArray::number(i) + ':'
                     + ("var(--v" + QByteArray::number(i - 1) + ") ").repeated(10) + ';';
        const QByteArray path =
            "<path d='M0 0h1' stroke='red' style='stroke-dasharray:var(--v9)'/>";
        QCOMPARE(error(drawing("<g style='" + style + "'>" + path.repeated(1000) + "</g>")),
                 "(no error)");
        const QByteArray loop =
            "<path d='M0 0h1' style='--a:var(--b);--b:var(--a);fill:var(--a)'/>";
        QCOMPARE(error(drawing(loop)), "(no error)");
        QByteArray large;
        for (int i = 0; i < 20'000; ++i)
            large += "<path d='M0 0h1' style='--a:" + QByteArray::number(i)
                     + ";stroke-dasharray:var(--a) var(--c)'/>";
        QCOMPARE(error(drawing("<g style='--c:" + QByteArray("1 ").repeated(4'900) + "'>" + large
                               + "</g>")),
                 "its style sheet is too large for so many elements.");
    }

    void aFileThatDoesNotFitIntoMemoryIsRefusedAtOnce()
    {
        QByteArray content = drawing("<path d='M0 0h1'/>");
        HugeFile file(content);
        const auto result = app::findFormat(u"svg")->read(file);
        QVERIFY(!result);
        QVERIFY2(result.error.startsWith("it needs about 1000000.0 GB")
                     || result.error.startsWith("it needs about 1,000,000.0 GB"),
                 qPrintable(result.error));
    }
    void boxesOfGroupsCannotMultiply()
    {
        const QByteArray open = "<g style='transform:scale(1);transform-box:fill-box'>";
        const QByteArray many = QByteArray("<path d='M0 0h1'/>").repeated(10'000);
        QVERIFY(error(drawing(open.repeated(400) + many + QByteArray("</g>").repeated(400)))
                    .contains("exceeds the limit"));
    }

    void gradientsOfGradientsEnd()
    {
        QByteArray defs;
        for (int i = 0; i < 1000; ++i)
            defs += "<linearGradient id='g" + QByteArray::number(i) + "' href='#g"
                    + QByteArray::number((i + 1) % 1000) + "'/>";
        QCOMPARE(error(drawing(defs + "<path d='M0 0h1' fill='url(#g0)'/>")), "(no error)");
    }

    void styleSheetsCannotMultiply()
    {
        const QByteArray rules = QByteArray("*{stroke:red}").repeated(20'000);
        const QByteArray lines = QByteArray("<path d='M0 0h1'/>").repeated(20'000);
        QCOMPARE(error(drawing("<style>" + rules + "</style>" + lines)),
                 "its style sheet is too large for so many elements.");
        const QByteArray list = QByteArray("a,").repeated(50'000),
                         body = QByteArray("fill:red;").repeated(50'000);
        QCOMPARE(error(drawing("<style>" + list + "b{" + body + "}</style><b/>")), "(no error)");
        QCOMPARE(error(drawing("<style>" + QByteArray("*,").repeated(50'000) + "b{" + body
                               + "}</style><path d='M0 0h1'/>")),
                 "its style sheet is too large for so many elements.");
    }

    void longDashPatternsAreLeftOut()
    {
        const QByteArray line = "<path d='M0 0h1' stroke='red' stroke-dasharray='"
                                + QByteArray("1 ").repeated(100'000) + "'/>";
        QVERIFY(shapeOf(line).style.dashes.empty());
        QCOMPARE(reportOf(line), "1 dash pattern that is too long");
    }

    void aMillionPointsAreAllRead()
    {
        QByteArray data = "M0 0";
        for (int i = 0; i < 1'000'000; ++i)
            data += i % 2 ? "l1 1" : "l1-1";
        const auto result = readText(drawing("<path d='" + data + "'/>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(app::sheetOf(result.value->document).shapes.at(0).paths.at(0).segments.size(),
                 1'000'000u);
    }

    void thousandsOfLayersBecomeOne()
    {
        const QByteArray one = "<path d='M0 0h1'/><g inkscape:groupmode='layer' "
                               "style='display:none'><path d='M0 0h1'/></g>";
        const auto result = readText(drawing(one.repeated(5000)));
        QVERIFY2(result, qPrintable(result.error));
        const app::Sheet sheet = app::sheetOf(result.value->document);
        QCOMPARE(sheet.shapes.size(), 10'000u);
        QCOMPARE(sheet.layers.size(), 1000u);
        for (std::size_t i = 0; i < sheet.shapes.size(); ++i)
            QCOMPARE(sheet.shown(sheet.shapes[i]), i % 2 == 0);
    }

    void aLayerForEachOfAHundredThousandObjects()
    {
        const auto result = readText(drawing(
            QByteArray("<g inkscape:groupmode='layer'><path d='M0 0h1'/></g>").repeated(100'000)));
        QVERIFY2(result, qPrintable(result.error));
        const app::Document& document = result.value->document;
        QCOMPARE(document.objects().size(), std::size_t(100'000));
        QCOMPARE(document.containers().childrenOf(0).size(), std::size_t(1000));
        QCOMPARE(lossLines(result.value->report).join(' '),
                 "Lost: 1 stack of too many layers; the upper layers became one");
        comesBack(document);
    }

    void aHundredThousandGroups()
    {
        QByteArray groups;
        for (int i = 0; i < 100'000; ++i)
            groups += "<g id='" + QByteArray::number(i) + "'><path d='M0 0h1'/></g>";
        const auto result = readText(drawing(groups));
        QVERIFY2(result, qPrintable(result.error));
        const app::Document& document = result.value->document;
        QCOMPARE(document.objects().size(), std::size_t(100'000));
        QCOMPARE(document.containers().size(), std::size_t(99'001)); // with their layer
        QCOMPARE(reportOf(groups), "1000 groups beyond the limit were dissolved");
        QVERIFY(!isLossy(*result.value));
        comesBack(document);
    }

    // Beyond the limits, too, what is in a hidden layer or group is hidden.
    void whatIsBeyondTheLimitStaysHidden()
    {
        const QByteArray path = "<path d='M0 0h1'/>";
        const QByteArray hidden = "<g inkscape:groupmode='layer' display='none'>" + path
                                  + "<g inkscape:label='x'>" + path + "</g></g>";
        const auto result = readText(drawing(hidden.repeated(1500)));
        QVERIFY2(result, qPrintable(result.error));
        const app::Document& document = result.value->document;
        for (std::size_t i = 0; i < document.objects().size(); ++i)
            QVERIFY(!document.shown(i));
        comesBack(document);
    }

    void theDeepestGroupsComeBack()
    {
        const QByteArray note = "<desc>" + QByteArray("<b>").repeated(10) + "x"
                                + QByteArray("</b>").repeated(10) + "</desc>";
        const QByteArray object = "<path d='M0 0h1'>" + note + "</path>";
        for (const int deep : {490, 499, 500, 505}) {
            const auto result =
                readText(drawing(QByteArray("<g inkscape:label='a'>").repeated(deep) + object
                                 + object + QByteArray("</g>").repeated(deep)));
            QVERIFY2(result, qPrintable(result.error));
            const app::Document& document = result.value->document;
            const auto around = document.containers().containerOf(0);
            QCOMPARE(document.containers().depthOf(around), std::min(deep + 1, 500));
            comesBack(document);
        }
    }

    void clipPathsCannotMultiply()
    {
        QByteArray points;
        for (int i = 0; i < 200'000; ++i)
            points += QByteArray::number(i % 100) + (i % 2 ? " 0 " : " 100 ");
        const QByteArray line = "<polyline points='" + points + "' fill='none' stroke='red'/>";
        const QByteArray clip = "<clipPath id='c'><circle cx='50' cy='50' r='40'/></clipPath>";
        const QByteArray around = "<g clip-path='url(#c)'>", end = "</g>";
        QCOMPARE(error(drawing(clip + around + line + end)), "(no error)");
        QVERIFY(error(drawing(clip + around.repeated(400) + line + end.repeated(400)))
                    .contains("limit of work"));
        const QByteArray shapes = QByteArray("<path d='M50 50h1'/>").repeated(100'000);
        QVERIFY(error(drawing(clip + around.repeated(400) + shapes + end.repeated(400)))
                    .contains("limit of work"));
        const auto curves = [](const QByteArray& one) {
            return "<path d='M0 0" + one.repeated(60'000) + "'/>";
        };
        QCOMPARE(error(drawing(clip + around + curves("c0 9 9 0 -1 0") + end)), "(no error)");
        QVERIFY(
            error(drawing(clip + around + curves("c0 1e9 1e9 0 -1 0") + end)).contains("points"));
    }

    // A clip path of ten clip paths, each of ten more.
    void clipPathsInClipPathsCannotMultiply()
    {
        QByteArray clips = "<clipPath id='c0'><rect width='50' height='50'/></clipPath>";
        for (int i = 1; i < 30; ++i)
            clips += "<clipPath id='c" + QByteArray::number(i) + "'>"
                     + ("<rect width='50' height='50' clip-path='url(#c" + QByteArray::number(i - 1)
                        + ")'/>")
                           .repeated(10)
                     + "</clipPath>";
        QVERIFY(error(drawing(clips + "<path clip-path='url(#c29)' d='M0 0h9'/>"))
                    .contains("limit of work"));
    }

    void longChainsOfClipPathsAreRefused()
    {
        QByteArray clips = "<clipPath id='c0'><rect width='50' height='50'/></clipPath>";
        for (int i = 1; i < 5000; ++i)
            clips += "<clipPath id='c" + QByteArray::number(i) + "' clip-path='url(#c"
                     + QByteArray::number(i - 1) + ")'><rect width='9' height='9'/></clipPath>";
        QVERIFY(error(drawing(clips + "<path clip-path='url(#c4999)' d='M0 0h9'/>"))
                    .contains("nests elements deeper"));
    }

    void largeClipPathsEnd_data()
    {
        QTest::addColumn<QByteArray>("clip");
        QTest::addColumn<QByteArray>("content");
        const auto row = [](const char* name, const QByteArray& clip, const QByteArray& content) {
            QTest::newRow(name) << "<clipPath id='c'>" + clip + "</clipPath>" << content;
        };
        const auto rings = [](int count, const QByteArray& ring) {
            QByteArray path = "<path d='";
            for (int i = 0; i < count; ++i)
                path += "M" + QByteArray::number(i % 300 / 3.0) + ' '
                        + QByteArray::number(i / 300 / 3.5) + ring;
            return path + "'/>";
        };
        const QByteArray line = "<path stroke='red' d='M0 0L100 99'/>";
        const QByteArray area = "<path d='M0 0H100V100z'/>";
        QByteArray star = "<path d='M0 0";
        for (int i = 0; i < 20'000; ++i)
            star += 'L' + QByteArray::number(i * 7919 % 1000 / 10.0) + ' '
                    + QByteArray::number(i * 104729 % 997 / 10.0);
        star += "'/>";
        row("10^5 rings", rings(100'000, "h.2v.2h-.2z"), line + area);
        row("10^5 round rings", rings(100'000, "a.1 .1 0 0 0 .1 .1a.1 .1 0 0 0 -.1 -.1z"),
            line + area);
        row("10^4 shapes", QByteArray("<circle cx='50' cy='50' r='9'/>").repeated(10'000), line);
        row("1,000 overlapping shapes",
            QByteArray("<circle cx='50' cy='50' r='9'/>").repeated(1'000), line + area);
        row("a star", star, line + area);
        row("a star in a star", star, star);
        row("an area of stars", "<circle cx='50' cy='50' r='40'/>", star);
        row("a comb in a comb", rings(5'000, "v100h.01v-100z"), rings(5'000, "h100v.01h-100z"));
        row("huge", "<circle cx='5e8' r='1e9'/>", line + area);
        row("nearly infinite", "<circle r='1e299'/>", line + area);
        row("a transform without a number", "<circle r='9' transform='scale(nan)'/>", line);
        row("a transform to a line", "<circle r='9' transform='scale(0 1)'/>", line);
    }
    void largeClipPathsEnd()
    {
        QFETCH(QByteArray, clip);
        QFETCH(QByteArray, content);
        QElapsedTimer timer;
        timer.start();
        const auto read = readText(drawing(clip + "<g clip-path='url(#c)'>" + content + "</g>"));
        QVERIFY(read || read.error.endsWith('.'));
        QVERIFY(!read || !read.value->report.empty());
        qInfo("%lld ms, %s", timer.elapsed(), // what hangs is ended by ctest
              read ? qPrintable(read.value->report.back().what) : qPrintable(read.error));
    }

    void memoryStaysBounded()
    {
        if (!memoryCanBeLimited)
            QSKIP("the sanitizer keeps what was freed, and more beside it");
        QVERIFY2(peakMegabytes() < 1500, qPrintable(QString::number(peakMegabytes())));
    }

private:
    static void comesBack(const app::Document& document)
    {
        const auto again = readText(textOf(document));
        QVERIFY2(again, qPrintable(again.error));
        QVERIFY(again.value->document == document);
    }
};

} // namespace formats_svg_hostile_test

TEST_CLASS(formats_svg_hostile_test::HostileTest, None)
#include "tests/app/formats/svg/hostile_test.moc"
