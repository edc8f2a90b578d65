// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/slide.h"
#include "app/teaching/trace_file.h"

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/test_class.h"

namespace teaching_slide_test {

using namespace app;

namespace {

struct PaintedText {
    QString text;
    double size; ///< of its font, in pixels of a slide
};

/// The texts on the slides of a trace, read from their SVG by an independent reader.
std::vector<PaintedText> textsOn(const TraceExport& trace)
{
    std::vector<PaintedText> texts;
    const auto files = traceBytes(trace, *findTraceFormat(QStringLiteral("svg")));
    for (const QByteArray& file : *files) {
        QXmlStreamReader xml(file);
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement
                && xml.name() == QStringLiteral("text")) {
                const double size = xml.attributes().value(QStringLiteral("font-size")).toDouble();
                texts.push_back({xml.readElementText(), size});
            }
        if (xml.hasError())
            qFatal("A slide is no XML: %s", qPrintable(xml.errorString()));
    }
    return texts;
}

TraceExport traceOf(const Variant& variant, const clipping::Segment& line)
{
    TraceExport trace{.tracedLine = {variant, line, {{-100, -75}, {100, 75}}, YAxis::Up, {}},
                      .narration = {}};
    trace.narration = narrationOf(trace.tracedLine);
    return trace;
}

/// A line that is cut, with long numbers, and one that is rejected after cuts.
const std::vector<clipping::Segment> lines{
    {{-160.123456789, -30.987654321}, {70.111111111, 129.999999999}},
    {{-170, 40}, {-20, 150}},
};

} // namespace

/// Slides are read from the last row of a lecture hall.
class SlideTest : public QObject {
    Q_OBJECT

private slots:
    /// The pseudo-code line of the step is on its slide with every word, in one row or in several.
    void noTextIsTooLowOrCutOff()
    {
        const double least = slideHeight / 40;
        std::size_t slides = 0;
        for (const Variant& variant : variants()) {
            TraceExport trace = traceOf(variant, lines[0]);
            for (std::size_t step = 0; step < trace.narration.steps.size(); ++step) {
                trace.only = step;
                QString written;
                for (const PaintedText& text : textsOn(trace)) {
                    QVERIFY2(text.size >= least && !text.text.contains(u'\u2026'),
                             qPrintable(QStringLiteral("%1: “%2” has %3 pixels")
                                            .arg(keyOf(variant), text.text)
                                            .arg(text.size)));
                    written += text.text.simplified() + u' ';
                }
                const int line = trace.narration.steps[step].line;
                const QString code = trace.narration.code.value(line - 1).simplified();
                QVERIFY2(written.contains(code),
                         qPrintable(keyOf(variant) + ": " + code + " | " + written));
                ++slides;
            }
        }
        QVERIFY(slides > 200);
    }
    /// The sentence has room even in the smallest font.
    void everySentenceHasRoom()
    {
        for (const Variant& variant : variants())
            for (const clipping::Segment& line : lines) {
                TraceExport trace = traceOf(variant, line);
                for (std::size_t step = 0; step < trace.narration.steps.size(); ++step) {
                    QFont font = QGuiApplication::font();
                    font.setPixelSize(18);
                    const QString sentence = slideSentence(trace.narration, step);
                    const QRectF area = sentenceArea();
                    const double height =
                        QFontMetricsF(font).boundingRect(area, Qt::TextWordWrap, sentence).height();
                    QVERIFY2(height <= area.height(), qPrintable(sentence));
                }
            }
    }
};

} // namespace teaching_slide_test

TEST_CLASS(teaching_slide_test::SlideTest, Gui)
#include "tests/app/teaching/slide_test.moc"
