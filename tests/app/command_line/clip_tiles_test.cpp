// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QImage>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_clip_tiles_test {

// `clearcut clip --tiles`: the files, read back by other programs.

namespace {

constexpr int dpi = 96;

/// 300 × 200 mm: a grid of lines, a filled disc, a cross.
QByteArray poster()
{
    QByteArray svg = "<svg xmlns='http://www.w3.org/2000/svg' width='300mm' height='200mm' "
                     "viewBox='0 0 300 200'>"
                     "<circle cx='150' cy='100' r='80' fill='#c8dcff' stroke='#204080' "
                     "stroke-width='2'/><g fill='none' stroke='#000' stroke-width='0.8'>";
    for (int i = 1; i < 10; ++i)
        svg += QStringLiteral("<path d='M%1 0L%2 200'/>").arg(i * 30).arg(300 - i * 30).toUtf8();
    return svg + "</g></svg>";
}

QImage seenBy(const QString& program, const QStringList& arguments, const QString& png)
{
    const auto ended = runProgram(program, arguments);
    return ended.code == 0 ? QImage(png).convertToFormat(QImage::Format_RGB32) : QImage();
}

/// How an independent reader paints a file at 96 dpi.
QImage svgSeen(const QString& path)
{
    const QString png = path + QStringLiteral(".png"), resolution = QString::number(dpi);
    return seenBy("rsvg-convert",
                  {"-b", "white", "-d", resolution, "-p", resolution, "-o", png, path}, png);
}
QImage pdfSeen(const QString& path, int page)
{
    const QString base = path + QString::number(page);
    return seenBy("pdftoppm",
                  {"-r", QString::number(dpi), "-png", "-f", QString::number(page), "-l",
                   QString::number(page), "-singlefile", path, base},
                  base + QStringLiteral(".png"));
}

int pixels(double millimetres) { return qRound(millimetres / 25.4 * dpi); }

/// Mean difference of two pictures, 0 to 255; 255 if their sizes differ by more than a pixel.
double difference(const QImage& a, const QImage& b)
{
    if (a.isNull() || std::abs(a.width() - b.width()) > 1 || std::abs(a.height() - b.height()) > 1)
        return 255;
    double sum = 0;
    const int width = std::min(a.width(), b.width()), height = std::min(a.height(), b.height());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum / width / height;
}

class Desk {
public:
    Desk() { writeText(input, poster()); }
    QString path(const QString& name) const { return folder.filePath(name); }
    Ended tiles(const QStringList& options) const
    {
        return clearcut(QStringList{"clip", input, "--tiles"} + options);
    }
    QStringList files(const QString& pattern) const
    {
        return QDir(folder.path()).entryList({pattern}, QDir::Files, QDir::Name);
    }

    QTemporaryDir folder;
    QString input = folder.filePath("poster.svg");
};

} // namespace

class ClipTilesTest : public QObject {
    Q_OBJECT

private slots:
    // The sheets laid edge to edge look like the drawing.
    void theSheetsAreTheDrawing()
    {
        const Desk desk;
        const auto run = desk.tiles({"3x2", "-o", desk.path("s-{row}-{column}.svg")});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY2(run.err.contains("Sheets: 3 columns × 2 rows of 100.0 × 100.0 mm: "),
                 run.err.constData());
        const QImage whole = svgSeen(desk.input);
        QCOMPARE(desk.files("s-*.svg").size(), 6);
        for (const int row : {1, 2})
            for (const int column : {1, 2, 3}) {
                const QImage sheet =
                    svgSeen(desk.path(QStringLiteral("s-%1-%2.svg").arg(row).arg(column)));
                const QRect place(pixels((column - 1) * 100), pixels((row - 1) * 100),
                                  sheet.width(), sheet.height());
                const double apart = difference(sheet, whole.copy(place));
                QVERIFY2(apart < 4,
                         qPrintable(QStringLiteral("%1-%2: %3").arg(row).arg(column).arg(apart)));
            }
    }

    // 3x2 is three columns in two rows; {n} counts row by row.
    void columnsComeFirst()
    {
        const Desk desk;
        QCOMPARE(desk.tiles({"3x1", "-o", desk.path("c-{row}-{column}-{n}.svg")}).code, 0);
        QCOMPARE(desk.files("c-*.svg"), (QStringList{"c-1-1-1.svg", "c-1-2-2.svg", "c-1-3-3.svg"}));
        QCOMPARE(svgSeen(desk.path("c-1-1-1.svg")).height(), pixels(200));
        const auto help = clearcut({"clip", "--help"}).out.simplified();
        QVERIFY2(help.contains("3x2 makes 3 columns side by side in 2 rows, 6 sheets."),
                 help.constData());
    }

    void emptySheetsAreLeftOut()
    {
        const Desk desk;
        writeText(desk.input, "<svg xmlns='http://www.w3.org/2000/svg' width='300mm' "
                              "height='200mm' viewBox='0 0 300 200'><path stroke='#000' "
                              "d='M10 10L90 90'/></svg>");
        const QStringList options{"3x2", "-o", desk.path("e-{n}.svg")};
        const auto some = desk.tiles(options);
        QCOMPARE(desk.files("e-*.svg"), QStringList{"e-1.svg"});
        QVERIFY2(some.err.contains("\n5 empty sheets were left out. --empty-sheets writes them.\n"),
                 some.err.constData());
        const auto all = desk.tiles(options + QStringList{"--empty-sheets"});
        QCOMPARE(desk.files("e-*.svg").size(), 6);
        QVERIFY(!all.err.contains("left out."));
        const auto none = desk.tiles(options + QStringList{"-w", "200,0,300,200"});
        QCOMPARE(none.code, 1);
        QVERIFY2(none.err.contains("All sheets are empty."), none.err.constData());
    }

    // 200 mm of two sheets of 105 mm: both have the 10 mm in the middle.
    void neighboursShareTheOverlap()
    {
        const Desk desk;
        QCOMPARE(desk.tiles({"1x2", "--overlap", "1cm", "-o", desk.path("o-{n}.svg")}).code, 0);
        const QImage upper = svgSeen(desk.path("o-1.svg")), lower = svgSeen(desk.path("o-2.svg"));
        QCOMPARE(upper.height(), pixels(105));
        const int strip = pixels(10);
        const double apart = difference(upper.copy(0, upper.height() - strip, upper.width(), strip),
                                        lower.copy(0, 0, lower.width(), strip));
        QVERIFY2(apart < 10, qPrintable(QString::number(apart)));
    }

    void aPageForEachSheet()
    {
        const Desk desk;
        const QString pdf = desk.path("all.pdf");
        QCOMPARE(desk.tiles({"2x2", "--marks", "-o", pdf}).code, 0);
        QCOMPARE(desk.tiles({"2x2", "--marks", "-o", desk.path("m-{n}.svg")}).code, 0);
        const auto info = runProgram("pdfinfo", {pdf});
        QVERIFY2(info.out.contains("Pages:           4"), info.out.constData());
        for (const int page : {1, 2, 3, 4}) {
            const double apart = difference(
                pdfSeen(pdf, page), svgSeen(desk.path(QStringLiteral("m-%1.svg").arg(page))));
            QVERIFY2(apart < 6, qPrintable(QStringLiteral("%1: %2").arg(page).arg(apart)));
        }
    }

    // Marks are in the margin; without them it is empty.
    void marksAreInTheMargins()
    {
        const Desk desk;
        const QStringList common{"2x1", "--sheet-margin", "12mm"};
        QCOMPARE(desk.tiles(common + QStringList{"-o", desk.path("plain-{n}.svg")}).code, 0);
        QCOMPARE(
            desk.tiles(common + QStringList{"--marks", "-o", desk.path("marked-{n}.svg")}).code, 0);
        const auto ink = [&](const QString& name, const QRect& place) {
            const QImage seen = svgSeen(desk.path(name));
            int dark = 0;
            for (int y = place.top(); y < place.bottom(); ++y)
                for (int x = place.left(); x < place.right(); ++x)
                    dark += qGray(seen.pixel(x, y)) < 200;
            return dark;
        };
        const QRect below(0, pixels(213), pixels(174), pixels(10));
        QCOMPARE(ink("plain-1.svg", below), 0);
        QVERIFY(ink("marked-1.svg", below) > 100);
    }

    void theOverviewShowsAllSheets()
    {
        const Desk desk;
        const QString pdf = desk.path("all.pdf");
        QCOMPARE(desk.tiles({"3x2", "--overview", "-o", pdf}).code, 0);
        QVERIFY(runProgram("pdfinfo", {pdf}).out.contains("Pages:           7"));
        const auto run = desk.tiles({"3x2", "--overview", "-o", desk.path("s-{row}-{column}.svg")});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(desk.files("s-*.svg").contains("s-overview.svg"));
        QCOMPARE(desk.files("s-*.svg").size(), 7);
        const QImage overview = svgSeen(desk.path("s-overview.svg"));
        QCOMPARE(overview.size(), svgSeen(desk.path("s-1-1.svg")).size());
        QVERIFY(difference(overview, pdfSeen(pdf, 1)) < 6);
        // The edge between the first two columns.
        const int edge = pixels(5 + 90 / 3.0), y = overview.height() / 2 - pixels(28);
        int darkest = 255;
        for (int x = edge - 2; x <= edge + 2; ++x)
            darkest = std::min(darkest, qGray(overview.pixel(x, y)));
        QVERIFY2(darkest < 160, qPrintable(QString::number(darkest)));
    }

    // Twice as large: twice the paper for the same drawing, four times the sheets.
    void theScaleIsThatOnPaper()
    {
        const Desk desk;
        QCOMPARE(desk.tiles({"1x1", "--scale", "200%", "-o", desk.path("large-{n}.svg")}).code, 0);
        const QImage large = svgSeen(desk.path("large-1.svg")), whole = svgSeen(desk.input);
        QCOMPARE(large.size(), QSize(pixels(600), pixels(400)));
        QVERIFY(
            difference(large.scaled(whole.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation),
                       whole)
            < 4);
        const auto run = desk.tiles({"a4", "--scale", "50%", "-o", desk.path("small-{n}.svg")});
        QVERIFY2(run.err.contains("1 column × 1 row of 210.0 × 297.0 mm"), run.err.constData());
    }

    void otherFormats()
    {
        const Desk desk;
        writeText(desk.path("lines.csv"), "x1,y1,x2,y2\n0,0,100,0\n0,10,30,10\n");
        const auto run = clearcut(
            {"clip", desk.path("lines.csv"), "--tiles", "2x1", "-o", desk.path("l-{n}.csv")});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(contentOf(desk.path("l-1.csv")).contains("0,0,50,0"));
        QVERIFY(contentOf(desk.path("l-2.csv")).contains("50,0,100,0"));
        QVERIFY(!contentOf(desk.path("l-2.csv")).contains("30,10"));
        QCOMPARE(desk.tiles({"2x1", "-o", desk.path("p-{n}.png")}).code, 0);
        QCOMPARE(QImage(desk.path("p-2.png")).size(), QSize(pixels(150), pixels(200)));
    }

    // An existing file is as before, if the new one cannot be written.
    void filesAreReplacedAsAWhole()
    {
        const Desk desk;
        writeText(desk.path("r-1.svg"), "before");
        QVERIFY(QDir(desk.folder.path()).mkdir("r-2.svg"));
        const auto run = desk.tiles({"2x1", "-o", desk.path("r-{n}.svg")});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("r-2.svg"), run.err.constData());
        QVERIFY(contentOf(desk.path("r-1.svg")).contains("<svg"));
        QVERIFY(QDir(desk.path("r-2.svg")).exists());
    }

    void whatIsWrongIsSaid_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const QStringList& options, const char* sentence) {
            QTest::newRow(sentence) << options << QByteArray(sentence);
        };
        row({"a4", "--overlap", "190mm", "-o", "x.pdf"},
            "Overlap must be less than 190\u00a0mm, the width of a sheet.");
        row({"a4", "--marks", "--sheet-margin", "1mm", "-o", "x.pdf"},
            "Marks need a margin of at least 5\u00a0mm on each sheet.");
        row({"a99", "-o", "x.pdf"},
            "--tiles a99: give columns and rows such as 3x2, a size such as 45mmx48mm, or a paper");
        row({"a4", "--scale", "10mm", "-o", "x.pdf"},
            "--scale 10mm: give a positive percentage such as 150%");
        row({"a4", "--scale", "-5%", "-o", "x.pdf"}, "give a positive percentage");
        row({"a4", "--scale", "1000000%", "-o", "x.pdf"}, "The scale must be between");
        row({"2x2", "-o", "x-{row}.svg"}, "is one name for 4 sheets. Put {row} and {column}");
    }
    void whatIsWrongIsSaid()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, sentence);
        const Desk desk;
        options.last() = desk.path(options.last());
        const auto run = desk.tiles(options);
        QVERIFY(run.code == 1 || run.code == 2);
        QVERIFY2(run.err.contains(sentence), run.err.constData());
        QCOMPARE(desk.files("*").size(), 1);
    }
    void optionsThatNeedTiles()
    {
        const Desk desk;
        for (const QString option : {"--overview", "--marks"}) {
            const auto run = clearcut({"clip", desk.input, option, "-o", desk.path("x.svg")});
            QCOMPARE(run.code, 2);
            QVERIFY2(run.err.contains(option.toUtf8() + " needs --tiles."), run.err.constData());
        }
    }
};

} // namespace command_line_clip_tiles_test

TEST_CLASS(command_line_clip_tiles_test::ClipTilesTest, Core)
#include "tests/app/command_line/clip_tiles_test.moc"
