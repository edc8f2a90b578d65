// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/app/charts/sample_charts.h"
#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace charts_chart_file_test {

using namespace app;

namespace {

Chart sampleChart() { return chartOf(sample::seven(), measures().front(), paperTables().front()); }

/// The mean difference of two pictures' pixels, of 255.
double difference(const QImage& a, const QImage& b)
{
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum / (double(a.width()) * a.height());
}

} // namespace

class ChartFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    const ChartLook look_ = chartLook(Ground::Light);

    QString written(const QString& name)
    {
        const QString path = folder_.filePath(name);
        const auto error = writeChart(sampleChart(), path, look_);
        return error ? *error : path;
    }
    /// What another program makes of one of our files, at 96 dots an inch.
    QImage seen(const QString& program, const QStringList& arguments)
    {
        const QString path = folder_.filePath("seen.png");
        const Ended ended = runProgram(program, QStringList(arguments) << path);
        return ended.code == 0 ? QImage(path) : QImage();
    }

private slots:
    void picturesAreTwiceAsFine()
    {
        const QImage image(written("chart.png"));
        QCOMPARE(image.size(), (usualSize(sampleChart(), look_) * 2).toSize());
        QVERIFY(image.text("Title").contains("lowest median = 1"));
        QCOMPARE(image.pixelColor(0, 0), look_.paper);
    }
    void librsvgPaintsTheSameSvg()
    {
        const QImage ours(written("chart.png")),
            theirs =
                seen("rsvg-convert", {"-w", QString::number(ours.width()), "-h",
                                      QString::number(ours.height()), written("chart.svg"), "-o"});
        QCOMPARE(theirs.size(), ours.size());
        QVERIFY2(difference(ours, theirs) < 3,
                 qPrintable(QString::number(difference(ours, theirs))));
    }
    void svgSaysItInWords()
    {
        QXmlStreamReader xml(contentOf(written("chart.svg")));
        QHash<QString, QString> texts;
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement
                && (xml.name() == u"title" || xml.name() == u"desc"))
                texts[xml.name().toString()] = xml.readElementText();
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(texts["title"], sampleChart().title);
        QVERIFY(texts["desc"].contains("Cohen-Sutherland"));
    }
    void popplerReadsThePdf()
    {
        const QString path = written("chart.pdf");
        const Ended text = runProgram("pdftotext", {"-layout", path, "-"});
        QCOMPARE(text.code, 0);
        for (const ChartRow& row : sampleChart().rows)
            for (const QString& part : QStringList(row.name) + row.numbers)
                QVERIFY2(text.out.contains(part.toUtf8()), qPrintable(part));
        const QImage ours(written("chart.png"));
        QVERIFY(runProgram("pdftoppm",
                           {"-png", "-singlefile", "-r", "192", path, folder_.filePath("seen")})
                    .code
                == 0);
        const QImage theirs = QImage(folder_.filePath("seen.png"));
        QVERIFY(std::abs(theirs.width() - ours.width()) <= 1);
        QVERIFY(std::abs(theirs.height() - ours.height()) <= 1);
        QVERIFY(difference(ours.scaled(theirs.size()), theirs) < 4);
    }
    void everyFormatHasItsEnding()
    {
        for (const ChartFormat& format : chartFormats()) {
            const QString name = QString("x.") + format.key.data();
            QVERIFY(QFile::exists(written(name.toUpper())));
            QCOMPARE(chartBytes(sampleChart(), format, look_).isEmpty(), false);
        }
    }
    void errorsNameTheFileAndWhatToDo()
    {
        QVERIFY(written("chart.unknown").contains("chart.unknown"));
        QVERIFY(written("chart.unknown").contains(".svg"));
        QVERIFY(!QFile::exists(folder_.filePath("chart.unknown")));
        QVERIFY(written("missing/chart.svg").startsWith("Cannot write"));
        for (const ChartFormat& format : chartFormats()) { // a disk without room
            QFile full("/dev/full");
            if (!full.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
                QSKIP("no /dev/full");
            const auto error = format.write(sampleChart(), look_, {300, 300}, full);
            QVERIFY2(error && error->endsWith('.'), format.key.data());
        }
    }
};

} // namespace charts_chart_file_test

TEST_CLASS(charts_chart_file_test::ChartFileTest, Gui)
#include "tests/app/charts/chart_file_test.moc"
