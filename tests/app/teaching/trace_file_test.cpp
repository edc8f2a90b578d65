// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/trace_file.h"

#include <QDateTime>
#include <QImageReader>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace teaching_trace_file_test {

using namespace app;

namespace {

/// A trace with cuts and an end.
TraceExport sample(std::string_view key = "matthes-drakopoulos")
{
    TraceExport trace{.tracedLine = {{clipping::findAlgorithm(key), clipping::Form::Corrected},
                                     {{-160, -30}, {70, 130}},
                                     {{-100, -75}, {100, 75}},
                                     YAxis::Up,
                                     {}},
                      .narration = {}};
    trace.narration = narrationOf(trace.tracedLine);
    return trace;
}

const TraceFormat& format(const char* key) { return *findTraceFormat(QString::fromLatin1(key)); }

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

class TraceFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    /// The files of a trace, written.
    QStringList written(const TraceExport& trace, const char* key)
    {
        const QStringList paths =
            tracePaths(trace, format(key), folder_.filePath(QStringLiteral("a.") + key));
        const auto bytes = traceBytes(trace, format(key));
        const auto error = bytes ? writeTrace(paths, *bytes) : QStringLiteral("no memory");
        return error ? QStringList{*error} : paths;
    }

private slots:
    void sameTraceSameBytes()
    {
        for (const TraceFormat& row : traceFormats()) {
            const auto first = traceBytes(sample(), row);
            const auto second = QDateTime::currentSecsSinceEpoch(); // which a PDF could hold
            while (row.key == "pdf" && QDateTime::currentSecsSinceEpoch() == second)
                QThread::msleep(10);
            QVERIFY2(first == traceBytes(sample(), row), row.key.data());
        }
    }

    void filesAreNumberedWhereThereAreSeveral()
    {
        const TraceExport trace = sample();
        const QString name = folder_.filePath("talk.svg");
        const QStringList paths = tracePaths(trace, format("svg"), name);
        QCOMPARE(paths.size(), qsizetype(trace.narration.steps.size()));
        QCOMPARE(paths[1], folder_.filePath("talk-02.svg"));
        QCOMPARE(tracePaths(trace, format("pdf"), folder_.filePath("talk.pdf")),
                 QStringList{folder_.filePath("talk.pdf")});
        TraceExport one = trace;
        one.only = 2;
        QCOMPARE(tracePaths(one, format("svg"), name), QStringList{name});
        QCOMPARE(tracePaths(one, format("svg"), folder_.path()),
                 QStringList{folder_.filePath("matthes-drakopoulos-03.svg")});
        QCOMPARE(tracePaths(trace, format("gif"), folder_.path()),
                 QStringList{folder_.filePath("matthes-drakopoulos.gif")});
    }

    void existingFilesAreNamed()
    {
        const QStringList paths = written(sample(), "png");
        QCOMPARE(existingOf(paths), paths);
        QVERIFY(QFile::remove(paths.front()));
        QCOMPARE(existingOf(paths), paths.sliced(1));
    }

    void librsvgPaintsTheSameSvg()
    {
        const QStringList svg = written(sample(), "svg"), png = written(sample(), "png");
        const QString seen = folder_.filePath("seen.png");
        for (qsizetype i : {qsizetype(0), svg.size() - 1}) {
            QCOMPARE(runProgram("rsvg-convert", {svg[i], "-o", seen}).code, 0);
            const QImage ours(png[i]), theirs(seen);
            QCOMPARE(ours.size(), QSize(1280, 720));
            QCOMPARE(theirs.size(), ours.size());
            QVERIFY2(difference(ours, theirs) < 3, QByteArray::number(difference(ours, theirs)));
        }
    }

    void popplerReadsThePdf()
    {
        const TraceExport trace = sample();
        const QString pdf = written(trace, "pdf").front();
        const Ended info = runProgram("pdfinfo", {pdf});
        QVERIFY2(info.out.contains(
                     "Pages:           " + QByteArray::number(trace.narration.steps.size()) + "\n"),
                 info.out);
        QVERIFY2(info.out.contains("960 x 540 pts"), info.out); // 16:9
        for (std::size_t step = 0; step < trace.narration.steps.size(); ++step) {
            const QString page = QString::number(step + 1);
            const QString words = QString::fromUtf8(
                runProgram("pdftotext", {"-raw", "-f", page, "-l", page, pdf, "-"}).out);
            QString flat = words;
            flat.replace(u'\n', u' ');
            QVERIFY2(flat.contains(trace.narration.steps[step].sentence), qPrintable(words));
            QVERIFY2(flat.contains(QStringLiteral("Step %1 of ").arg(page)), qPrintable(words));
            QVERIFY(flat.contains("End 1") && flat.contains("xmin = \u2212100"));
        }
        QCOMPARE(runProgram("pdftoppm", {"-r", "96", "-png", "-f", "1", "-l", "1", "-singlefile",
                                         pdf, folder_.filePath("page")})
                     .code,
                 0);
        const QImage page(folder_.filePath("page.png")), ours(written(trace, "png").front());
        QCOMPARE(page.size(), ours.size());
        QVERIFY2(difference(page, ours) < 4, QByteArray::number(difference(page, ours)));
    }

    /// A picture of less than 1280 pixels was once the upper left of the whole one.
    void everyWidthShowsTheWholePicture()
    {
        TraceExport trace = sample();
        trace.only = trace.narration.steps.size() - 1;
        const QImage whole(written(trace, "png").front());
        for (const int width : {64, 320, 640, 900, 1279, 1920}) {
            trace.scale = width / double(whole.width());
            for (const char* key : {"png", "gif"}) {
                const QImage image(written(trace, key).front());
                const QImage expected =
                    whole.scaled(image.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
                QCOMPARE(image.size(), QSize(width, qRound(width * 9 / 16.0)));
                QVERIFY2(difference(image, expected) < 4,
                         qPrintable(QStringLiteral("%1 at %2: %3")
                                        .arg(QLatin1StringView(key))
                                        .arg(width)
                                        .arg(difference(image, expected))));
            }
        }
    }

    void theGifHasAFrameForEachStep() // by Qt's own reader, not giflib's
    {
        TraceExport trace = sample();
        trace.scale = 0.5;
        QImageReader reader(written(trace, "gif").front());
        QCOMPARE(reader.imageCount(), int(trace.narration.steps.size()));
        QCOMPARE(reader.size(), QSize(640, 360));
        QCOMPARE(reader.loopCount(), -1); // for ever
        const QStringList png = written(trace, "png");
        for (const QString& path : png) {
            const QImage frame = reader.read();
            QVERIFY2(difference(frame, QImage(path)) < 1.5,
                     QByteArray::number(difference(frame, QImage(path))));
            QVERIFY(reader.nextImageDelay() >= 1200);
        }
    }

    void jsonHoldsTheWholeTrace()
    {
        for (const auto& algorithm : clipping::algorithms()) {
            const TraceExport trace = sample(algorithm.key);
            QJsonParseError error;
            const QJsonObject all =
                QJsonDocument::fromJson(traceBytes(trace, format("json"))->front(), &error)
                    .object();
            QVERIFY2(error.error == QJsonParseError::NoError, qPrintable(error.errorString()));
            QCOMPARE(all["format"], "clearcut-trace-1");
            QCOMPARE(all["algorithm"].toString().toStdString(), std::string(algorithm.key));
            QCOMPARE(all["line"].toArray(), (QJsonArray{-160, -30, 70, 130}));
            const auto& visible = *trace.narration.visible;
            QCOMPARE(all["visible"].toArray(),
                     (QJsonArray{visible.a.x, visible.a.y, visible.b.x, visible.b.y})); // each bit
            const QJsonArray steps = all["steps"].toArray();
            QCOMPARE(steps.size(), qsizetype(trace.narration.steps.size()));
            for (qsizetype i = 0; i < steps.size(); ++i) {
                const NarratedStep& narrated = trace.narration.steps[std::size_t(i)];
                const QJsonObject step = steps[i].toObject();
                QCOMPARE(step["sentence"].toString(), narrated.sentence);
                QCOMPARE(step["left"].toArray()[3].toDouble(), narrated.left.b.y);
                QCOMPARE(step["variables"].toArray().size(), qsizetype(narrated.variables.size()));
                QCOMPARE(step["operations"]["comparisons"].toInteger(),
                         qint64(narrated.cost.comparisons));
            }
        }
    }

    void nonFiniteNumbersAreWordsInJson()
    {
        TraceExport trace = sample();
        trace.narration.steps.front().left.a = {std::nan(""), -INFINITY};
        trace.narration.steps.front().sentence = QStringLiteral("\"quoted\" \\ \n");
        const auto all = QJsonDocument::fromJson(traceBytes(trace, format("json"))->front());
        const QJsonValue step = all["steps"][0];
        QCOMPARE(step["left"][0], "nan");
        QCOMPARE(step["left"][1], "-inf");
        QCOMPARE(step["sentence"].toString(), trace.narration.steps.front().sentence);
    }

    void theTracesOfAllRowsBecomeSlides() // published endless ones too
    {
        for (const Variant& variant : variants()) {
            TraceExport trace = sample();
            trace.tracedLine.variant = variant;
            trace.tracedLine.window = {{0.1, 0.1}, {3, 3}};
            trace.tracedLine.line = {{1, 1}, {-1, -1}};
            trace.narration = narrationOf(trace.tracedLine);
            trace.only = trace.narration.steps.size() - 1;
            trace.ground = Ground::Dark;
            QVERIFY(traceBytes(trace, format("png")));
            QVERIFY(!traceBytes(trace, format("text"))->front().isEmpty());
        }
    }

    void refusedLinesAreShownWithTheReason()
    {
        TraceExport trace = sample();
        trace.tracedLine.line.a.x = std::nan("");
        trace.narration = narrationOf(trace.tracedLine);
        for (const TraceFormat& row : traceFormats())
            QCOMPARE(traceBytes(trace, row)->size(), 1);
        QVERIFY(traceBytes(trace, format("text"))->front().contains("x1 is not a finite number"));
    }

    void fullDiskIsReported()
    {
        const auto bytes = traceBytes(sample(), format("pdf"));
        const auto error = writeTrace({QStringLiteral("/dev/full")}, *bytes);
        QVERIFY(error && error->startsWith("Cannot write /dev/full: "));
        QVERIFY(writeTrace({folder_.filePath("no/such/folder.pdf")}, *bytes));
    }
};

} // namespace teaching_trace_file_test

TEST_CLASS(teaching_trace_file_test::TraceFileTest, Gui)
#include "tests/app/teaching/trace_file_test.moc"
