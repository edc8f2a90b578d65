// SPDX-License-Identifier: GPL-3.0-or-later
// Pages, units and numbers at the ends of the range: every reader and writer either refuses them in
// one sentence, or gives a file of finite numbers.
#include "app/document/document_builder.h"
#include "app/formats/format.h"
#include "app/formats/painted.h"

#include <QBuffer>
#include <QRegularExpression>
#include <QTest>

#include <limits>
#include <random>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace formats_extreme_pages_test {

namespace {

const QList<double> extremes{0,      5e-324, 1e-310, 1e-300, 1e-200,
                             1e-100, 1e-30,  1e-9,   0.3,    1,
                             297.5,  1e9,    1e30,   1e99,   1e100,
                             1e101,  1e200,  1e300,  1e307,  std::numeric_limits<double>::max()};

// Some number of the list, sometimes with another sign.
class Numbers {
public:
    double next() { return extremes[qsizetype(bits_() % std::size_t(extremes.size()))]; }
    double signedNext() { return bits_() % 3 == 0 ? -next() : next(); }
    std::uint32_t below(std::uint32_t end) { return bits_() % end; }

private:
    std::mt19937 bits_{17};
};

QByteArray textOf(double number) { return QByteArray::number(number, 'g', 17); }

// What the streams of a PDF file hold, with everything else.
QByteArray unpacked(const QByteArray& pdf)
{
    QByteArray text = pdf;
    for (qsizetype at = pdf.indexOf("stream\n"); at >= 0; at = pdf.indexOf("\nstream\n", at + 1)) {
        const auto begin = pdf.indexOf("stream\n", at) + 7;
        QByteArray packed = pdf.mid(begin, pdf.indexOf("\nendstream", begin) - begin);
        packed.prepend(QByteArray("\0\1\0\0", 4));
        text += qUncompress(packed);
    }
    return text;
}

bool hasNoNumber(const QByteArray& text)
{
    static const QRegularExpression word(QStringLiteral("\\b(nan|-nan|inf|-inf|infinity)\\b"),
                                         QRegularExpression::CaseInsensitiveOption);
    return word.match(QString::fromLatin1(text)).hasMatch();
}

constexpr double coarse = 1e-6; // dpi, for pictures of few pixels

// Why the writing of a drawing is wrong; empty if it is right. What is written can be read again,
// if the page is as a reader makes it.
enum class PageIs { AsRead, Any };
QString faultOfWriting(const app::Document& document, const app::Format& format,
                       const app::WriteOptions& options, PageIs page = PageIs::AsRead)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const auto error = format.write(document, buffer, options);
    const QString name = QString::fromLatin1(format.key.data(), qsizetype(format.key.size()));
    if (error)
        return error->endsWith(u'.') && !hasNoNumber(error->toUtf8()) ? QString() : *error;
    const QByteArray bytes = buffer.data();
    if (bytes.isEmpty()
        || (name != u"png" && hasNoNumber(name == u"pdf" ? unpacked(bytes) : bytes)))
        return name + QStringLiteral(": ") + QString::fromLatin1(bytes.left(2000));
    if (!format.read || page == PageIs::Any)
        return {};
    buffer.close();
    buffer.open(QIODevice::ReadOnly);
    const auto again = format.read(buffer);
    return again ? QString() : name + QStringLiteral(": ") + again.error;
}

} // namespace

class ExtremePagesTest : public QObject {
    Q_OBJECT

private slots:
    void unitsWithoutASizeAreRefused()
    {
        for (const QByteArray page : {"width='1e308in' height='1e308in' viewBox='0 0 1 1'",
                                      "width='1mm' height='1mm' viewBox='0 0 1e-300 1e-300'",
                                      "width='1e-300mm' height='1e-300mm' viewBox='0 0 1 1'",
                                      "width='5e-324' height='5e-324'", "viewBox='0 0 5e-324 1'",
                                      "width='1mm' height='1mm' viewBox='1e300 0 1e-90 1e-90'"}) {
            const auto result = readText("<svg xmlns='http://www.w3.org/2000/svg' " + page
                                         + "><path d='M0 0L1 1' stroke='red'/></svg>");
            QVERIFY2(!result, page);
            QVERIFY2(result.error.startsWith("the page is too large or too small"), page);
            QVERIFY(result.error.endsWith(u'.'));
        }
    }

    void everyReaderAndWriter()
    {
        Numbers numbers;
        int kept = 0;
        for (int round = 0; round < 800; ++round) {
            const QByteArray unit = QByteArrayList{"mm", "in", "px", "", "%"}[numbers.below(5)];
            QByteArray page;
            if (numbers.below(4) > 0)
                page += " width='" + textOf(numbers.next()) + unit + '\'';
            if (numbers.below(4) > 0)
                page += " height='" + textOf(numbers.next()) + unit + '\'';
            if (numbers.below(4) > 0)
                page += " viewBox='" + textOf(numbers.signedNext()) + ' '
                        + textOf(numbers.signedNext()) + ' ' + textOf(numbers.next()) + ' '
                        + textOf(numbers.next()) + '\'';
            const QByteArrayList aspects{"", " preserveAspectRatio='none'",
                                         " preserveAspectRatio='xMidYMid slice'"};
            const QByteArray text =
                "<svg xmlns='http://www.w3.org/2000/svg'" + page + aspects[numbers.below(3)]
                + "><path d='M0 0L" + textOf(numbers.signedNext()) + ' '
                + textOf(numbers.signedNext()) + "C0 1 2 3 4 5' stroke='red' stroke-dasharray='"
                + textOf(numbers.next()) + "' stroke-width='" + textOf(numbers.next())
                + "' transform='scale(" + textOf(numbers.signedNext()) + ")'/></svg>";
            const auto result = readText(text);
            VERIFY_OR_SAY(result || (result.error.endsWith(u'.') && !result.error.contains("inf")),
                          text + result.error.toUtf8());
            if (!result)
                continue;
            ++kept;
            app::WriteOptions options;
            options.precision = int(numbers.below(4)) - 1;
            options.dpi = coarse;
            options.tolerance = round % 20 == 0 ? 0 : 1e300; // few chords
            for (const app::Format& format : app::formats()) {
                if (!format.write)
                    continue;
                const QString fault = faultOfWriting(result.value->document, format, options);
                VERIFY_OR_SAY(fault.isEmpty(), text + '\n' + fault.toUtf8());
            }
        }
        QVERIFY2(kept > 80, qPrintable(QString::number(kept)));
    }

    void everyTable()
    {
        Numbers numbers;
        for (int round = 0; round < 1000; ++round) {
            QByteArray text;
            for (std::uint32_t rows = 1 + numbers.below(3); rows > 0; --rows) {
                for (int i = 0; i < 4; ++i)
                    text += textOf(numbers.signedNext()) + ',';
                text += ",#000000," + textOf(numbers.next()) + '\n';
            }
            QBuffer buffer(&text);
            buffer.open(QIODevice::ReadOnly);
            const auto result = app::findFormat(u"csv")->read(buffer);
            if (!result) {
                VERIFY_OR_SAY(result.error.contains("too large"), text + result.error.toUtf8());
                continue;
            }
            app::WriteOptions options;
            options.dpi = coarse;
            for (const app::Format& format : app::formats()) {
                if (!format.write)
                    continue;
                const QString fault = faultOfWriting(result.value->document, format, options);
                VERIFY_OR_SAY(fault.isEmpty(), text + '\n' + fault.toUtf8());
            }
        }
    }

    // Also pages that no reader gives.
    void everyPageOfADocument()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Numbers numbers;
        const auto some = [&] {
            const std::uint32_t kind = numbers.below(12);
            return kind == 0 ? infinity : kind == 1 ? std::nan("") : numbers.signedNext();
        };
        const auto length = [&] {
            return app::Length{some(), app::units()[1 + numbers.below(6)].unit};
        };
        for (int round = 0; round < 3000; ++round) {
            app::DocumentBuilder builder;
            builder.open({.name = "a"});
            builder.add({app::Path(clipping::Segment{{0, 0}, {1, 1}}), {.stroke = app::Colour{}}});
            builder.close();
            app::Page page;
            page.min = {some(), some()};
            page.size = {some(), some()};
            page.width = length();
            page.height = length();
            const bool usable = !app::faultOf(page);
            const app::Document document = builder.take(page);
            for (const app::Format& format : app::formats()) {
                if (!format.write || (format.key == "csv" && !usable))
                    continue; // a table has no page
                app::WriteOptions options;
                options.dpi = coarse;
                const QString fault = faultOfWriting(document, format, options, PageIs::Any);
                VERIFY_OR_SAY(fault.isEmpty(), fault.toUtf8());
            }
        }
    }

    void picturesOfAnyResolution()
    {
        for (const double dpi : extremes) {
            app::WriteOptions options;
            options.dpi = dpi;
            if (dpi > 0)
                QCOMPARE(faultOfWriting({}, *app::findFormat(u"png"), options), "");
        }
    }
};

} // namespace formats_extreme_pages_test

TEST_CLASS(formats_extreme_pages_test::ExtremePagesTest, Core)
#include "tests/app/formats/extreme_pages_test.moc"
