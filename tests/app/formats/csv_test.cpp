// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include <QBuffer>
#include <QTest>

#include <algorithm>
#include <random>
#include <string_view>

#include "tests/app/document/sheet.h"
#include "tests/app/formats/lossy.h"
#include "tests/deep.h"
#include "tests/test_class.h"

namespace formats_csv_test {

namespace {

app::Result<app::Imported> read(QByteArray text)
{
    QBuffer buffer(&text);
    buffer.open(QIODevice::ReadOnly);
    return app::findFormat(u"csv")->read(buffer);
}

QByteArray written(const app::Document& document, const app::WriteOptions& options = {})
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const auto error = app::findFormat(u"csv")->write(document, buffer, options);
    return error ? error->toUtf8() : buffer.data();
}

/// A file of many equal lines, with random access, of which any size can be told.
class ManyLines : public QIODevice {
public:
    explicit ManyLines(qint64 size) : size_(size) { open(ReadOnly | Unbuffered); }

    qint64 size() const override { return size_; }
    bool atEnd() const override { return given == size_; }
    qint64 given = 0;

protected:
    qint64 readData(char* bytes, qint64 most) override
    {
        const qint64 count = std::min(most, size_ - given);
        for (qint64 i = 0; i < count; ++i)
            bytes[i] = row[(given + i) % qint64(row.size())];
        given += count;
        return count;
    }
    qint64 writeData(const char*, qint64) override { return -1; }

private:
    static constexpr std::string_view row = "10.25,20.5,100.75,200\n";
    qint64 size_;
};

app::Subpath line(app::Point a, app::Point b) { return {a, {{b}}, false}; }

} // namespace

class CsvTest : public QObject {
    Q_OBJECT

private slots:
    void columnsByPosition()
    {
        const auto read1 = read("1,2,3,4\n-5.5,1e2,0,0,walls,#102030,2.5,99\n7,7,7,7,,#01020304\n");
        QVERIFY2(read1, qPrintable(read1.error));
        const app::Sheet sheet = app::sheetOf(read1.value->document);
        QCOMPARE(sheet.shapes.size(), 3u);
        QCOMPARE(sheet.layers.size(), 2u);
        QCOMPARE(sheet.layers[0].name, QStringLiteral("Drawing"));
        QCOMPARE(sheet.layers[1].name, QStringLiteral("walls"));
        QCOMPARE(sheet.shapes[0].paths[0], line({1, 2}, {3, 4}));
        QCOMPARE(sheet.shapes[0].style.stroke, std::optional(app::Colour{}));
        QCOMPARE(sheet.shapes[1].paths[0], (app::Subpath{{7, 7}, {}, false}));
        QCOMPARE(sheet.shapes[1].style.stroke, std::optional(app::Colour{1, 2, 3, 4}));
        QCOMPARE(sheet.shapes[2].paths[0], line({-5.5, 100}, {0, 0}));
        QCOMPARE(sheet.shapes[2].style.width, 2.5);
        QCOMPARE(read1.value->rows, (std::vector<std::uint32_t>{0, 2, 1})); // layer by layer
        QVERIFY(!isLossy(*read1.value));
    }

    void aFileThatDoesNotFitIntoMemoryIsRefusedAtOnce()
    {
        ManyLines file(1'000'000'000'000'000);
        const auto result = app::findFormat(u"csv")->read(file);
        QVERIFY(!result);
        QVERIFY2(result.error.startsWith("it needs about ")
                     && result.error.contains(" GB are free"),
                 qPrintable(result.error));
        QVERIFY(file.given < 2'000'000);
    }
    void manyLinesAreRead()
    {
        const int lines = 6'000'000 / tests::caseStep(); // more than were allowed once
        ManyLines file(22 * qint64(lines));
        const auto result = app::findFormat(u"csv")->read(file);
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document.objects().size(), std::size_t(lines));
    }
    void aHeaderIsHonoured()
    {
        const auto read1 =
            read("colour, Y2 ,x2,y1,X1,speed\n#ff0000,4,3,2,1,9\n\"#00ff00\",8,7,6,5\n");
        QVERIFY2(read1, qPrintable(read1.error));
        const auto& shapes = app::sheetOf(read1.value->document).shapes;
        QCOMPARE(shapes.size(), 2u);
        QCOMPARE(shapes[0].paths[0], line({1, 2}, {3, 4}));
        QCOMPARE(shapes[1].paths[0], line({5, 6}, {7, 8}));
        QCOMPARE(shapes[0].style.stroke, std::optional(app::Colour{255, 0, 0, 255}));
        QVERIFY(isLossy(*read1.value)); // the column speed
    }

    void quotesCommentsAndLineEnds()
    {
        const auto read1 = read("\xef\xbb\xbf# made by hand\r\nx1,y1,x2,y2,layer\r\n\r\n"
                                "1,2,3,4,\"a \"\"b\"\",\r\nc\"\r\n#1,1,1,1\n5,6,7,8,d");
        QVERIFY2(read1, qPrintable(read1.error));
        const app::Sheet sheet = app::sheetOf(read1.value->document);
        QCOMPARE(sheet.shapes.size(), 2u);
        QCOMPARE(sheet.layers[0].name, QStringLiteral("a \"b\",\r\nc"));
        QCOMPARE(sheet.layers[1].name, QStringLiteral("d"));
    }

    // The rows of a layer come together, in their order, with their own colour, however they
    // alternate.
    void layersAndColoursMayAlternate()
    {
        const QByteArrayList layers{"b", "", "a"}, colours{"#010203", "", "#00000080", "#010203"};
        QByteArray text;
        std::vector<std::uint32_t> order;
        constexpr std::uint32_t rows = 20'000; // more than a block of objects holds
        for (std::uint32_t i = 0; i < rows; ++i)
            text += "1,2,3," + QByteArray::number(i) + ',' + layers[i % 3] + ','
                    + colours[i / 2 % 4] + '\n';
        for (const std::uint32_t layer : {0U, 1U, 2U})
            for (std::uint32_t i = layer; i < rows; i += 3)
                order.push_back(i);
        const auto result = read(text);
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->rows, order);
        const app::Document& document = result.value->document;
        QCOMPARE(document.styles().size(), 3u);
        const auto ids = document.containers().childrenOf(0);
        QCOMPARE(document.containers()[ids.at(1)].name, QStringLiteral("Drawing"));
        for (std::size_t i = 0; i < order.size(); ++i) {
            const app::ObjectView object = document.objects()[i];
            const QByteArray colour = colours[order[i] / 2 % 4];
            QCOMPARE(object.singleLine()->b.y, double(order[i]));
            QCOMPARE(document.containers().layerOf(i), ids.at(order[i] % 3));
            QCOMPARE(object.style().stroke->blue, colour == "#010203" ? 3 : 0);
            QCOMPARE(object.style().stroke->alpha, colour == "#00000080" ? 128 : 255);
        }
    }

    void layersBeyondTheMostAreOne()
    {
        QByteArray text = "1,2,3,4,a\n1,2,3,4,a\n";
        for (int i = 0; i < 1001; ++i)
            text += "1,2,3,4,layer " + QByteArray::number(i) + "\n";
        text += "1,2,3,4,layer 1000\n1,2,3,4,layer 998\n1,2,3,4,a\n";
        const auto result = read(text);
        QVERIFY2(result, qPrintable(result.error));
        const app::Containers& layers = result.value->document.containers();
        const auto ids = layers.childrenOf(0);
        QCOMPARE(ids.size(), 1000u);
        QCOMPARE(layers.rangeOf(ids.front()).size(), 3u);
        QCOMPARE(layers[ids.back()].name, QStringLiteral("layer 998"));
        QCOMPARE(layers.rangeOf(ids.back()).size(), 5u);
        QCOMPARE(result.value->report.size(), 1u);
        QCOMPARE(result.value->report.front().count, 3);
    }

    void aNameMayHaveAnyByte()
    {
        const auto result = read("1,2,3,4,\xff\xfe x\n");
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(app::sheetOf(result.value->document).layers[0].name,
                 QStringLiteral("\ufffd\ufffd x"));
    }

    void badRowsSayTheirLine_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const QByteArray& text, const char* sentence) {
            QTest::newRow(name) << text << QString::fromUtf8(sentence);
        };
        row("short", "# hi\n1,2,3,4\n1,2,3\n",
            "line 3 has 3 columns; x1, y1, x2 and y2 are needed.");
        row("one column", "1,2,3,4\n1\n", "line 2 has 1 column; x1, y1, x2 and y2 are needed.");
        row("NaN", "1,2,3,4\n1,nan,3,4\n", "line 2 has “nan” where a number is needed.");
        row("infinite", "1,2,3,4\n\n1,2,inf,4\n", "line 3 has “inf” where a number is needed.");
        row("1e400", "1,2,3,1e400",
            "line 1 has “1e400”, which is too large; numbers go up to 1e300.");
        row("near overflow", "1,2,3,-1e301",
            "line 1 has “-1e301”, which is too large; numbers go up to 1e300.");
        row("the first is too large", "1e308,2,3,4",
            "line 1 has “1e308”, which is too large; numbers go up to 1e300.");
        row("infinite", "1,2,3,-inf", "line 1 has “-inf” where a number is needed.");
        row("letters", "1,2,3,1e308x", "line 1 has “1e308x” where a number is needed.");
        row("empty", "x1,y1,x2,y2\n1,2,,4\n", "line 2 has “” where a number is needed.");
        row("long", "1,2,3,4,a,#000000,1,0,extra", "line 1 has 9 columns; at most 8 are possible.");
        row("longer than header", "x1,y1,x2,y2\n1,2,3,4,5",
            "line 2 has 5 columns; at most 4 are possible.");
        row("no header", "from,to\n",
            "line 1 is neither four numbers nor a header with x1, y1, x2 and y2; it has 2 columns: "
            "“from”, “to”.");
        row("no header with semicolons", "a;b;c;d;e;f;g\n",
            "line 1 is neither four numbers nor a header with x1, y1, x2 and y2; it has 7 columns: "
            "“a”, “b”, “c”, “d”, “e”, “f”, ….");
        row("a sentence", "This is no table.\n",
            "line 1 is neither four numbers nor a header with x1, y1, x2 and y2; it has 4 columns: "
            "“This”, “is”, “no”, “table.”.");
        row("three semicolons", "1;2;3\n", "line 1 has 3 columns; x1, y1, x2 and y2 are needed.");
        row("three blanks", "1 2 3\n", "line 1 has 3 columns; x1, y1, x2 and y2 are needed.");
        row("decimal commas between commas", "x1,y1,x2,y2\n1,5,1,5,20,5\n",
            "line 2 has 6 columns; at most 4 are possible.");
        row("thousands", "x1;y1;x2;y2\n1.234,5;1;1;1\n",
            "line 2 has “1.234,5” where a number is needed.");
        row("commas and points", "1,5;2;3;4\n1,5;2.5;3;4\n",
            "line 2 has both decimal commas and points: “1,5” and “2.5”.");
        row("UTF-16",
            QByteArray("\xff\xfe"
                       "1\0,\0"
                       "1\0,\0",
                       10),
            "line 1 is not UTF-8. Save the table as CSV in UTF-8.");
        row("twice", "x1,y1,x2,y2,x1\n", "line 1 names the column “x1” twice.");
        row("colour", "1,2,3,4,a,reddish\n",
            "line 1 has the colour “reddish”; write it as #rrggbb or #rrggbbaa.");
        row("width", "1,2,3,4,a,#000000,-1\n",
            "line 1 has the width “-1”; write a number that is not negative.");
        row("open quote", "1,2,3,4\n1,2,3,4,\"abc\n\n",
            "line 2 opens a quotation mark that is never closed.");
        row("after quote", "1,2,3,4,\"a\"b\n", "line 1 has text after a closing quotation mark.");
        row("endless commas", QByteArray(3'000'000, ','), "line 1 is too long for CSV.");
        row("endless", QByteArray(3'000'000, '\0'), "line 1 is too long for CSV.");
        row("line after a quoted one", "1,2,3,4,\"a\r\nb\"\r\nx,2,3,4\r\n",
            "line 3 has “x” where a number is needed.");
    }
    void badRowsSayTheirLine()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, sentence);
        const auto result = read(text);
        QVERIFY(!result);
        QCOMPARE(result.error, sentence);
    }

    // The same lines, however they are separated, named and written.
    void dialects_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const QByteArray& text) {
            QTest::newRow(name) << text;
        };
        const QByteArray end = "\r\n";
        row("semicolons", "1.5;2;-3;4e1;a b;#ff0000;0.5\n5;6;7;8;a b;#ff0000;0.5\n");
        row("decimal commas", "x1;y1;x2;y2;layer;colour;width\n1,5;2;-3;4e1;a b;#ff0000;0,5\n"
                              "5;6;7;8,0;a b;red;,5\n");
        row("decimal commas at once", "1,5;2,0;-3,0;40,0;a b;#ff0000;0,5\n5;6;7;8;a b;#f00;0,5");
        row("quotes", "\"x1\";\"y1\";\"x2\";\"y2\";\"layer\";\"color\";\"width\"\n"
                      "\"1,5\";\"2\";-3;40;\"a b\";#ff0000;0,5\n5;6;7;8;\"a b\";#ff0000;0,5\n");
        row("tabs", "x1\ty1\tx2\ty2\tlayer\tcolour\twidth" + end
                        + "1.5\t2\t-3\t40\ta b\t#ff0000\t.5" + end + end
                        + "5\t6\t7\t8\ta b\t#ff0000\t.5" + end);
        row("blanks", "  1.5 2\t -3   40 \"a b\" #ff0000 .5  \n5 6 7 8 \"a b\" #ff0000 .5");
        row("a mark and comments", "\xef\xbb\xbf# a;b\nx1;y1;x2;y2;layer;colour;width\n1,5;2;-3;40;"
                                   "a b;#ff0000;,5\n# c,d\n5;6;7;8;a b;#ff0000;,5\n");
        row("from zero", "x0,y0,x1,y1,layer,color,Line Width\n1.5,2,-3,40,a b,#ff0000,.5\n"
                         "5,6,7,8,a b,#ff0000,.5\n");
        row("in another order", "Y0;X1;stroke_width;X0;Y1;color;layer\n2;-3;0,5;1,5;40;red;a b\n"
                                "6;7;0,5;5;8;red;a b\n");
        for (const char* names : {"start_x,start_y,end_x,end_y", "X start,Y start,X end,Y end",
                                  "x_start,y_start,x_end,y_end", "from-x,from-y,to-x,to-y",
                                  "ax,ay,bx,by", "xA,yA,xB,yB", "p1.x,p1.y,p2.x,p2.y"})
            row(names, QByteArray(names)
                           + ",layer,colour,width\n1.5,2,-3,40,a b,red,.5\n5,6,7,8,a b,red,.5\n");
    }
    void dialects()
    {
        QFETCH(QByteArray, text);
        const auto expected = read("1.5,2,-3,40,a b,#ff0000,0.5\n5,6,7,8,a b,#ff0000,0.5\n");
        const auto result = read(text);
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document, expected.value->document);
        QVERIFY(!isLossy(*result.value));
    }

    void separatorsAreTold()
    {
        const auto told = [](const QByteArray& text) {
            return read(text).value->report.at(0).what;
        };
        const QString rest = " between its columns; a comma is a decimal comma";
        QCOMPARE(told("1;2;3;4"), "table has semicolons" + rest);
        QCOMPARE(told("1\t2\t3\t4"), "table has tabs" + rest);
        QCOMPARE(told("1 2 3 4"), "table has blanks" + rest);
        QVERIFY(read("1, 2, 3, 4, a layer with blanks").value->report.empty());
        QVERIFY(read("x1, y1, x2, y2\n1, 2, 3, 4").value->report.empty());
    }

    void dashesAreLines()
    {
        app::Sheet sheet;
        app::Style style{.stroke = app::Colour{}};
        style.dashes = {10, 10};
        sheet.shapes = {{{line({10, 20}, {90, 20})}, style, {}, 0, false}};
        const QByteArray end = ",Drawing,#000000,1";
        const auto rows = [&] { return written(app::documentOf(sheet)).split('\n').mid(1); };
        QCOMPARE(rows(), (QByteArrayList{"10,20,20,20" + end, "30,20,40,20" + end,
                                         "50,20,60,20" + end, "70,20,80,20" + end, ""}));
        sheet.shapes[0].style.dashOffset = 15;
        QCOMPARE(rows().at(0), "15,20,25,20" + end);
        // A dash goes round a corner as two lines; an odd pattern alternates; points are points.
        sheet.shapes[0] = {{{{0, 0}, {{{6, 0}}, {{6, 9}}}, false}}, style, {}, 0, false};
        QCOMPARE(rows(), (QByteArrayList{"0,0,6,0" + end, "6,0,6,4" + end, ""}));
        sheet.shapes[0].style.dashes = {4};
        QCOMPARE(rows(), (QByteArrayList{"0,0,4,0" + end, "6,2,6,6" + end, ""}));
        sheet.shapes[0].style.dashes = {0, 5};
        QCOMPARE(rows().at(1), "5,0,5,0" + end);
        sheet.shapes[0].style.dashes = {1e-300}; // too fine: solid
        QCOMPARE(rows().size(), 3);
    }

    void dashesStayInsideTheWindow()
    {
        std::mt19937 random(3);
        const auto number = [&] { return double(random()) / 7e8; };
        for (int round = 0; round < 300; ++round) {
            app::Sheet sheet;
            app::Style style{.stroke = app::Colour{}};
            style.dashes = {number() + 0.01, number()};
            const app::Point a{number(), number()}, b{number(), number()};
            sheet.shapes = {{{line(a, b)}, style, {}, 0, false}};
            for (const auto& piece :
                 app::sheetOf(read(written(app::documentOf(sheet))).value->document).shapes)
                for (const app::Point& p :
                     {piece.paths[0].start, piece.paths[0].segments.empty()
                                                ? piece.paths[0].start
                                                : piece.paths[0].segments[0].to})
                    for (int axis : {0, 1})
                        QVERIFY(p[axis] >= std::min(a[axis], b[axis])
                                && p[axis] <= std::max(a[axis], b[axis]));
        }
    }

    void anEmptyFileIsAnEmptyDrawing()
    {
        const auto result = read("");
        QVERIFY(result);
        QVERIFY(result.value->document.objects().empty());
        QCOMPARE(written(result.value->document), "x1,y1,x2,y2,layer,colour,width\n");
    }

    void comesBackBitForBit()
    {
        std::mt19937_64 random(5);
        const auto number = [&] { return std::ldexp(double(random()), int(random() % 400) - 300); };
        app::Sheet sheet;
        sheet.layers = {{QStringLiteral("a,b")}, {QStringLiteral("\"π\"\n# ")}};
        for (std::uint32_t i = 0; i < 2000; ++i) {
            app::Style style{.stroke = app::Colour{1, 2, 3, std::uint8_t(random())}};
            style.width = number();
            sheet.shapes.push_back(
                {{line({number(), number()}, {-number(), number()})}, style, {}, i / 1000, false});
        }
        const QByteArray text = written(app::documentOf(sheet));
        const auto back = read(text);
        QVERIFY2(back, qPrintable(back.error));
        QCOMPARE(app::sheetOf(back.value->document).shapes, sheet.shapes);
        QCOMPARE(app::sheetOf(back.value->document).layers, sheet.layers);
        QCOMPARE(written(back.value->document), text);
        QCOMPARE(read(written(back.value->document)).value->document, back.value->document);
    }

    void writesWhatIsSeen()
    {
        app::Sheet sheet;
        const app::Subpath corner{{0, 0}, {{{1, 0}}, {{1, 1}}}, true};
        sheet.shapes = {{{corner}, {.fill = app::Colour{255, 0, 0, 128}}, {}, 0, false},
                        {{corner}, {.stroke = app::Colour{}}, {}, 0, true},
                        {{corner}, {}, {}, 0, false}};
        QCOMPARE(written(app::documentOf(sheet)),
                 "x1,y1,x2,y2,layer,colour,width\n0,0,1,0,Drawing,#ff000080,1\n"
                 "1,0,1,1,Drawing,#ff000080,1\n1,1,0,0,Drawing,#ff000080,1\n");
        app::WriteOptions options;
        options.sources = {7, 8, 9};
        QVERIFY(written(app::documentOf(sheet), options)
                    .endsWith(",source\n0,0,1,0,Drawing,#ff000080,1,7\n"
                              "1,0,1,1,Drawing,#ff000080,1,7\n"
                              "1,1,0,0,Drawing,#ff000080,1,7\n"));
    }

    void decimalsMoveIntoTheWindow()
    {
        app::Sheet sheet;
        sheet.shapes = {{{line({1.26, 2}, {0.34, 1})}, {.stroke = app::Colour{}}, {}, 0, false}};
        app::WriteOptions options;
        options.precision = 1;
        options.bounds = {{0.34, 0}, {1.26, 5}};
        QVERIFY(written(app::documentOf(sheet), options).contains("\n1.2,2,0.4,1,"));
    }
};

} // namespace formats_csv_test

TEST_CLASS(formats_csv_test::CsvTest, Core)
#include "tests/app/formats/csv_test.moc"
