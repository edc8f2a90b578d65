// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/content_of.h"
#include "tests/test_class.h"

namespace command_line_part_options_test {

namespace {

const QByteArray drawing =
    "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='80mm' viewBox='0 0 100 80' "
    "xmlns:i='http://www.inkscape.org/namespaces/inkscape'>"
    "<g i:groupmode='layer' i:label='Logo'><path d='M10 10H30V30H10Z' fill='#c00000' "
    "stroke='#c00000' stroke-width='2'/><path d='M0 0H9' stroke='#000' display='none'/></g>"
    "<g i:groupmode='layer' i:label='Lines'><path d='M0 50H100' stroke='#000'/></g></svg>";

} // namespace

class PartOptionsTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

    Ended run(const QString& command, const char* file, const QStringList& options)
    {
        return clearcut(QStringList{command, "-", "--from", "svg", "-o", path(file)} + options,
                        drawing);
    }
    app::Document written(const char* file) const
    {
        const auto read = app::readFile(path(file));
        if (!read)
            qFatal("%s", qPrintable(read.error));
        return read.value->document;
    }

private slots:
    void oneLayerIsWritten()
    {
        for (const char* command : {"convert", "clip"}) {
            const auto ended = run(command, "layer.svg", {"--layer", "Logo"});
            QVERIFY2(ended.code == 0, ended.err);
            const app::Document document = written("layer.svg");
            QCOMPARE(document.objects().size(), std::size_t(1)); // the hidden one is not seen
            QCOMPARE(document.containers().size(), std::size_t(1));
            QCOMPARE(document.page().width, (app::Length{100, app::Unit::Mm}));
        }
        const auto unknown = run("convert", "layer.svg", {"--layer", "Roof"});
        QCOMPARE(unknown.code, 1);
        QVERIFY2(unknown.err.contains("There is no layer “Roof”. The layers are: Logo, Lines."),
                 unknown.err);
    }
    void thePaperIsFitted()
    {
        QCOMPARE(run("convert", "drawn.svg", {"--layer", "Logo", "--fit-paper"}).code, 0);
        QCOMPARE(written("drawn.svg").page().rectangle(), (clipping::Window{{9, 9}, {31, 31}}));
        QCOMPARE(written("drawn.svg").page().width, (app::Length{22, app::Unit::Mm}));
        QCOMPARE(run("clip", "cut.svg", {"-w", "5,5,45,35", "--fit-paper"}).code, 0);
        QCOMPARE(written("cut.svg").page().rectangle(), (clipping::Window{{5, 5}, {45, 35}}));
        // What is kept outside has no bounds but its own.
        QCOMPARE(run("clip", "out.svg", {"-w", "5,5,45,35", "-k", "outside", "--fit-paper"}).code,
                 0);
        QCOMPARE(written("out.svg").page().rectangle(), (clipping::Window{{0, 49.5}, {100, 50.5}}));
    }
    void aPictureIsTransparentOrColoured()
    {
        const QStringList logo{"--layer", "Logo", "--fit-paper", "--dpi", "254", "--background"};
        QCOMPARE(run("convert", "a.png", logo + QStringList{"none"}).code, 0);
        const QImage image(path("a.png"));
        QCOMPARE(image.size(), QSize(220, 220));
        QVERIFY(image.hasAlphaChannel());
        QCOMPARE(run("convert", "b.png", {"--background", "teal", "--dpi", "25.4"}).code, 0);
        QCOMPARE(QImage(path("b.png")).pixelColor(99, 79), QColor(0, 128, 128));
        const auto pdf = run("convert", "c.pdf", {"--background", "teal"});
        QVERIFY2(pdf.code == 0, pdf.err);
        const auto seen =
            runProgram("pdftoppm", {"-r", "25.4", "-png", "-singlefile", path("c.pdf"), path("c")});
        QCOMPARE(seen.code, 0);
        QCOMPARE(QImage(path("c.png")).pixelColor(90, 70), QColor(0, 128, 128));
    }
    void thePagesOwnBackgroundIsWrittenIfItIsExported()
    {
        for (const bool exported : {false, true}) {
            QFile file(path("own.svg"));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("<svg xmlns='http://www.w3.org/2000/svg' xmlns:clearcut='urn:clearcut:1' "
                       "width='9mm' height='9mm'><metadata><clearcut:page background='#008080' "
                       "export-background='");
            file.write(exported ? "yes'/></metadata>" : "no'/></metadata>");
            file.write("<path d='M0 0 9 9' stroke='black'/></svg>");
            file.close();
            const auto made = clearcut(
                QStringList{"convert", path("own.svg"), "-o", path("own.png"), "--dpi", "25.4"});
            QVERIFY2(made.code == 0, made.err);
            const QColor teal(0, 128, 128), white(Qt::white);
            QCOMPARE(QImage(path("own.png")).pixelColor(8, 0), exported ? teal : white);
            clearcut({"convert", path("own.svg"), "-o", path("own.pdf")});
            runProgram("pdftoppm",
                       {"-r", "25.4", "-png", "-singlefile", path("own.pdf"), path("p")});
            QCOMPARE(QImage(path("p.png")).pixelColor(7, 1), exported ? teal : white);
        }
    }
    void onlySvgIsPlain()
    {
        QCOMPARE(run("convert", "plain.svg", {"--plain"}).code, 0);
        QVERIFY(!contentOf(path("plain.svg")).contains("inkscape"));
        const auto pdf = run("convert", "plain.pdf", {"--plain"});
        QCOMPARE(pdf.code, 2);
        QVERIFY2(pdf.err.contains("--plain: a file of type pdf is no SVG file"), pdf.err);
    }
    void aWrongBackgroundIsRefused()
    {
        const auto svg = run("convert", "d.svg", {"--background", "teal"});
        QCOMPARE(svg.code, 2);
        QVERIFY2(svg.err.contains("--background: a file of type svg has no background"), svg.err);
        const auto colour = run("convert", "d.png", {"--background", "blurple"});
        QCOMPARE(colour.code, 2);
        QVERIFY2(colour.err.contains("--background blurple: give a colour"), colour.err);
        QVERIFY(!QFile::exists(path("d.svg")) && !QFile::exists(path("d.png")));
    }
    // The column source still names rows of the input.
    void rowsOfALayerKeepTheirNumbers()
    {
        const QByteArray table = "x1,y1,x2,y2,layer\n0,0,9,9,a\n1,1,8,8,b\n2,2,7,7,a\n";
        const auto ended = clearcut({"clip", "-", "--from", "csv", "-w", "0,0,5,5", "--layer", "a",
                                     "--to", "csv", "-o", "-", "-q"},
                                    table);
        QVERIFY2(ended.code == 0, ended.err);
        QCOMPARE(ended.out.count('\n'), 3);
        const QList<QByteArray> rows = ended.out.split('\n');
        QVERIFY2(rows[1].endsWith(",0") && rows[2].endsWith(",2"), ended.out);
    }
};

} // namespace command_line_part_options_test

TEST_CLASS(command_line_part_options_test::PartOptionsTest, Core)
#include "tests/app/command_line/part_options_test.moc"
