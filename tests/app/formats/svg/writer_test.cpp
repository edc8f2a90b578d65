// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <random>

#include "tests/app/formats/failing_disk.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_writer_test {

namespace {

app::Shape lineShape(const app::Point& a, const app::Point& b,
                     const app::Style& style = {.stroke = app::Colour{}})
{
    return {{{a, {{b}}, false}}, style, {}, 0, false};
}

app::Sheet sheetWith(std::vector<app::Shape> shapes)
{
    app::Sheet sheet;
    sheet.shapes = std::move(shapes);
    return sheet;
}

QByteArray bodyOf(const app::Sheet& sheet, const app::WriteOptions& options = {})
{
    const QByteArray text = textOf(sheet, options);
    const auto begin = text.indexOf("<g ");
    return text.mid(begin, text.indexOf("</svg>") - begin);
}

} // namespace

class WriterTest : public QObject {
    Q_OBJECT

private slots:
    void head()
    {
        app::Sheet sheet;
        sheet.page = {{-1, 2}, {30.5, 40}, {30.5, app::Unit::Mm}, {4, app::Unit::Cm}};
        sheet.window = {{0.1, -0.25}, {1e21, 1.0 / 3}};
        const QByteArray text = textOf(sheet);
        QVERIFY(text.contains(" width=\"30.5mm\" height=\"4cm\" viewBox=\"-1 2 30.5 40\""));
        QVERIFY(text.contains("<clearcut:window xmin=\"0.1\" ymin=\"-0.25\" "
                              "xmax=\"1000000000000000000000\" ymax=\"0.3333333333333333\"/>"));
        QVERIFY(text.contains("xmlns:clearcut=\"urn:clearcut:1\""));
    }

    void aPlainFileIsNothingButSvg()
    {
        const auto read = readText(
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:clearcut='urn:clearcut:1' width='9mm' "
            "height='9mm' viewBox='0 0 9 9'><metadata><clearcut:page scale='50'/>"
            "<clearcut:window xmin='0' ymin='0' xmax='1' ymax='1'/></metadata>"
            "<path stroke='black' d='M0 0 5 5'/><path stroke='black' display='none' "
            "clearcut:recipe='rectangle 1 2 3 4' d='M1 2H4V6H1Z'/></svg>");
        const app::Document& document = read.value->document;
        const QByteArray usual = textOf(document), plain = textOf(document, {.plain = true});
        QVERIFY(usual.contains("clearcut:recipe") && usual.contains("clearcut:window"));
        for (const char* other : {"clearcut", "inkscape", "sodipodi"}) {
            QVERIFY(usual.contains(other));
            QVERIFY2(!plain.contains(other), plain);
        }
        const auto back = readText(plain);
        QCOMPARE(back.value->document.objects().size(), 2u);
        QVERIFY(back.value->document.objects()[1].hidden());
        QVERIFY(back.value->report.empty());
    }

    void elementsThatFit()
    {
        const app::Style black{.stroke = app::Colour{}};
        const auto one = [&](std::vector<app::Subpath> paths) {
            QByteArray body = bodyOf(sheetWith({{std::move(paths), black, {}, 0, false}}));
            body.remove(0, body.indexOf('\n') + 1);
            return body.left(body.indexOf(" fill="));
        };
        QCOMPARE(one({{{1, 2}, {{{3, 4}}}, false}}), "<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"");
        QCOMPARE(one({{{1, 2}, {}, false}}), "<line x1=\"1\" y1=\"2\" x2=\"1\" y2=\"2\"");
        QCOMPARE(one({{{1, 2}, {{{3, 4}}, {{5, 6}}}, false}}), "<polyline points=\"1 2 3 4 5 6\"");
        QCOMPARE(one({{{1, 2}, {{{3, 4}}, {{5, 6}}}, true}}), "<polygon points=\"1 2 3 4 5 6\"");
        QCOMPARE(one({{{1, 2}, {}, true}}), "<path d=\"M1 2Z\"");
        QCOMPARE(one({{{1, 2}, {{{3, 4}, {5, 6}, {7, 8}, true}}, false}}),
                 "<path d=\"M1 2C5 6 7 8 3 4\"");
        QCOMPARE(one({{{1, 2}, {{{3, 4}}}, false}, {{5, 6}, {}, false}}),
                 "<path d=\"M1 2L3 4M5 6L5 6\"");
    }

    void eachObjectHasItsStyle() // other programs would show a <g> as a group
    {
        QCOMPARE(bodyOf(sheetWith({lineShape({0, 0}, {1, 1}), lineShape({2, 2}, {3, 3})})),
                 "<g inkscape:groupmode=\"layer\" inkscape:label=\"Drawing\">\n"
                 "<line x1=\"0\" y1=\"0\" x2=\"1\" y2=\"1\" fill=\"none\" stroke=\"#000000\"/>\n"
                 "<line x1=\"2\" y1=\"2\" x2=\"3\" y2=\"3\" fill=\"none\" stroke=\"#000000\"/>\n"
                 "</g>\n");
    }

    void runsOfOneStyleShareAGroupInLargeDrawings()
    {
        const app::Style red{.stroke = app::Colour{255, 0, 0, 51}, .width = 2};
        std::vector<app::Shape> shapes(10'000, lineShape({0, 0}, {1, 1}));
        shapes.push_back(lineShape({2, 2}, {3, 3}, red));
        QByteArray body = bodyOf(sheetWith(shapes));
        const QByteArray line = "<line x1=\"0\" y1=\"0\" x2=\"1\" y2=\"1\"/>\n";
        QCOMPARE(body.count(line), 10'000);
        QCOMPARE(body.replace(line, {}),
                 "<g inkscape:groupmode=\"layer\" inkscape:label=\"Drawing\">\n"
                 "<g fill=\"none\" stroke=\"#000000\">\n</g>\n"
                 "<line x1=\"2\" y1=\"2\" x2=\"3\" y2=\"3\" fill=\"none\" stroke=\"#ff0000\" "
                 "stroke-opacity=\"0.2\" stroke-width=\"2\"/>\n</g>\n");
    }

    void aHundredThousandLinesStaySmall()
    {
        std::vector<app::Shape> shapes;
        for (int row = 0; row < 100; ++row)
            for (int column = 0; column < 1000; ++column) {
                const app::Point at(column, row);
                shapes.push_back(lineShape(at, at + 5.0));
            }
        QVERIFY(textOf(sheetWith(shapes)).size() < 5'000'000);
    }

    void hiddenStaysHidden()
    {
        app::Shape shape = lineShape({0, 0}, {1, 1});
        shape.hidden = true;
        app::Sheet sheet = sheetWith({shape});
        sheet.layers.front().visible = false;
        QCOMPARE(bodyOf(sheet).count("display=\"none\""), 2);
    }

    void limitedPrecisionStaysInside()
    {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> part(0, 1);
        for (int precision = 0; precision <= 4; ++precision) {
            const clipping::Window window{{-10.34567, -3.14159}, {20.98765, 8.88888}};
            std::vector<app::Shape> shapes;
            const auto inside = [&] {
                return window.min
                       + (window.max - window.min) * app::Point{part(random), part(random)};
            };
            for (int i = 0; i < 200; ++i)
                shapes.push_back(
                    lineShape(i % 2 ? window.min : inside(), i % 3 ? window.max : inside()));
            app::WriteOptions options;
            options.precision = precision;
            options.bounds = window;
            const QByteArray text = textOf(sheetWith(shapes), options);
            const auto read = readText(text);
            QVERIFY(read);
            for (const app::Shape& shape : app::sheetOf(read.value->document).shapes)
                for (const app::Point& p : {shape.paths[0].start, shape.paths[0].segments[0].to})
                    QVERIFY2(p.x >= window.min.x && p.x <= window.max.x && p.y >= window.min.y
                                 && p.y <= window.max.y,
                             text);
        }
    }

    void aFullDiskIsReported()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.svg");
        const auto sheet = sheetWith(std::vector<app::Shape>(20'000, lineShape({0, 0}, {1, 1})));
        QVERIFY(!app::writeFile(app::documentOf(sheet), path));
        const auto size = std::size_t(QFileInfo(path).size());
        QVERIFY(size > 500'000);
        for (const std::size_t room : {std::size_t(0), size / 2, size - 16385, size - 1}) {
            QVERIFY(QFile(path).resize(3));
            const disk::Failing failing(disk::Step::Write, room);
            const auto error = app::writeFile(app::documentOf(sheet), path);
            QCOMPARE(error.value_or(""), "Cannot write " + path + ": No space left on device.");
            QCOMPARE(QFileInfo(path).size(), 3);
        }
    }
};

} // namespace formats_svg_writer_test

TEST_CLASS(formats_svg_writer_test::WriterTest, None)
#include "tests/app/formats/svg/writer_test.moc"
