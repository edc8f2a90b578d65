// SPDX-License-Identifier: GPL-3.0-or-later
// Common errors of well-formedness that other programs pass over: read, and told.
#include "app/formats/loss_text.h"

#include <QStringEncoder>
#include <QTest>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_lenient_xml_test {

namespace {

constexpr char declaration[] = "<?xml version='1.0'?>\n";

QStringList remarks(const QByteArray& text)
{
    const auto result = readText(text);
    return result ? lossLines(result.value->report) : QStringList(result.error);
}

QByteArray bare(const QByteArray& elements)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>" + elements + "</svg>";
}

} // namespace

class LenientXmlTest : public QObject {
    Q_OBJECT

private slots:
    void anUndeclaredPrefixMeansWhatItUsuallyDoes()
    {
        const auto result = readText(bare("<g inkscape:groupmode='layer' inkscape:label='Pen 1'>"
                                          "<line x2='9'/></g><use xlink:href='#a'/>"));
        QVERIFY2(result, qPrintable(result.error));
        const app::Sheet sheet = app::sheetOf(result.value->document);
        QCOMPARE(sheet.layers.at(0).name, "Pen 1");
        QCOMPARE(lossLines(result.value->report),
                 QStringList("Changed: 2 prefixes “inkscape”, “xlink” without a declaration were "
                             "read as usual (first in line 1)"));
        QVERIFY(!isLossy(*result.value));
    }

    void unknownPrefixesAreReadAsOfOtherPrograms()
    {
        QCOMPARE(remarks(bare("<a:b c:d='1'/><path d='M0 0h1' c:e='f'/>")),
                 QStringList("Changed: 2 prefixes “a”, “c” without a declaration were read as "
                             "usual (first in line 1)"));
        QCOMPARE(remarks("<svg:svg width='9' height='9'><svg:path d='M0 0h1'/></svg:svg>"),
                 QStringList(
                     "Changed: 1 prefix “svg” without a declaration was read as usual (line 1)"));
        // Declared at one place, but not at another.
        QCOMPARE(remarks("\n" + QByteArray(declaration)
                         + bare("<g xmlns:p='urn:p' p:q='1'/>\n<g p:q='1'/>"))
                     .last(),
                 "Changed: 1 prefix “p” without a declaration was read as usual (line 4)");
    }

    void metadataWithAnUndeclaredPrefixComesBack()
    {
        const auto result =
            readText(bare("<metadata><rdf:RDF><x:y z:w='1'/></rdf:RDF></metadata>"));
        QVERIFY2(result, qPrintable(result.error));
        const QByteArray text = textOf(result.value->document);
        const auto again = readText(text);
        QVERIFY2(again, qPrintable(again.error));
        QVERIFY(again.value->document == result.value->document);
        QVERIFY(again.value->report.empty());
        QCOMPARE(textOf(again.value->document), text);
    }

    void otherErrorsStayErrors()
    {
        for (const QByteArray elements : {"<g></a>", "<g x='1' x='2'/>", "<g inkscape:label='a'><",
                                          "&nosuchthing;", "<1/>", "<g a:b='1'></c:d>"}) {
            const auto result = readText(bare(elements));
            QVERIFY2(!result, elements);
            QVERIFY2(result.error.startsWith("line 1 "), qPrintable(result.error));
        }
    }

    void charactersOfHtml()
    {
        const auto result =
            readText(bare("\n<title>A&nbsp;&copy;\n&eacute;</title><g id='x&nbsp;y'>"
                          "<path d='M0 0h1'/></g>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document.about().title,
                 QString::fromUtf8("<title>A\u00a0©\né</title>"));
        QCOMPARE(lossLines(result.value->report),
                 QStringList("Changed: 4 names of characters without a declaration were read as in "
                             "HTML: “&nbsp;”, “&copy;”, “&eacute;” (first in line 2)"));
        // What the file declares itself counts.
        const auto declared = readText("<!DOCTYPE svg [<!ENTITY nbsp 'N'>]>"
                                       + bare("<title>&nbsp;</title><path d='M0 0h1'/>"));
        QCOMPARE(declared.value->document.about().title, "<title>N</title>");
        QVERIFY(declared.value->report.empty());
    }

    void blanksBeforeTheDeclaration()
    {
        const QByteArray mark = "\xef\xbb\xbf", drawing = declaration + bare("<path d='M0 0h1'/>");
        const QString told = "Changed: 1 beginning with blanks before <?xml was skipped";
        for (const QByteArray& begin :
             {QByteArray("\n"), QByteArray(" \t\r\n\n"), mark + ' ', ' ' + mark, mark + mark}) {
            QCOMPARE(remarks(begin + drawing), QStringList(told));
            QCOMPARE(readText(begin + drawing).value->document.objects().size(), std::size_t(1));
        }
        QCOMPARE(remarks(mark + drawing), QStringList());
        QCOMPARE(remarks("\n" + bare("<path d='M0 0h1'/>")), QStringList());
        // Lines are those of the file.
        QVERIFY(readText("\n\n" + QByteArray(declaration) + bare("\n<path d='M0 nan'/>"))
                    .error.startsWith("line 5 has nan"));
        QVERIFY(readText("\n\n" + QByteArray(declaration) + bare("\n<g></a>"))
                    .error.startsWith("line 5 is not correct XML"));
    }

    void namesOfCharactersBelowADocumentType()
    {
        // Expat takes unknown names for declared in the file that it does not fetch.
        const QByteArray type = "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' "
                                "'http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd'>";
        const auto result =
            readText(type
                     + bare("<g id='x&nbsp;y'><title>a&eacute;b</title><path d='M0 0h1'/></g>"
                            "<!-- &nbsp; --><style><![CDATA[ /* &nbsp; */ ]]></style>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(lossLines(result.value->report),
                 QStringList("Changed: 2 names of characters without a declaration were read as in "
                             "HTML: “&nbsp;”, “&eacute;” (first in line 1)"));
        for (const QByteArray elements : {"<g id='&nosuch;'/>", "<title>&nosuch;</title>"}) {
            const auto refused = readText(type + bare(elements));
            QVERIFY2(!refused, elements);
            QCOMPARE(refused.error, "line 1 is not correct XML (undefined entity “nosuch”).");
        }
    }

    void encodings_data()
    {
        QTest::addColumn<QByteArray>("encoding");
        QTest::addColumn<QByteArray>("title"); // "é"
        QTest::newRow("UTF-8") << QByteArray("UTF-8") << QByteArray("\xc3\xa9");
        QTest::newRow("as some write it") << QByteArray("utf8") << QByteArray("\xc3\xa9");
        QTest::newRow("Latin 1") << QByteArray("ISO-8859-1") << QByteArray("\xe9");
        QTest::newRow("Windows") << QByteArray("windows-1252") << QByteArray("\xe9");
    }
    void encodings()
    {
        QFETCH(QByteArray, encoding);
        QFETCH(QByteArray, title);
        const auto result = readText(
            "<?xml version='1.0' encoding='" + encoding + "'?>\n"
            + bare("<title>" + title + "</title><path d='M0 0h1'/><g/>\n<g/><path d='x'/>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document.about().title, QString::fromUtf8("<title>é</title>"));
        QCOMPARE(lossLines(result.value->report).size(), 1);
        QVERIFY(lossLines(result.value->report).at(0).contains("line 3"));
        QVERIFY(!readText("<?xml version='1.0' encoding='nosuch'?>" + bare("<g/>")));
    }
    void wideEncodings()
    {
        const QString text =
            QString::fromUtf8("<!DOCTYPE svg SYSTEM 'svg.dtd'>"
                              + bare("<title>é</title><path d='M0 0h1'/><g id='a&amp;b&#99;'/>"));
        for (const auto encoding : {QStringConverter::Utf16LE, QStringConverter::Utf16BE}) {
            QStringEncoder encoder(encoding, QStringConverter::Flag::WriteBom);
            const auto result = readText(encoder(text));
            QVERIFY2(result, qPrintable(result.error));
            QCOMPARE(result.value->document.about().title, QString::fromUtf8("<title>é</title>"));
        }
    }
    /// Longer than what is read at once; in time that grows with its length.
    void longTokens()
    {
        QByteArray data = "M0 0";
        while (data.size() < 3'000'000)
            data += "h1 1 1 1";
        const auto result = readText(bare("<path d='" + data + "'/>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document.objects().size(), std::size_t(1));
    }
    void manyDeclarations()
    {
        const auto declared = [](int count) {
            QByteArray text;
            for (int i = 0; i < count; ++i)
                text += " xmlns:p" + QByteArray::number(i) + "='u'";
            return "<g" + text + "/>";
        };
        QVERIFY(readText(bare("<path d='M0 0h1'/>" + declared(900))));
        QVERIFY(readText(bare("<path d='M0 0h1'/>" + declared(1100)))
                    .error.contains("more than 1000 namespaces"));
        QByteArray used;
        for (int i = 0; i < 101; ++i)
            used += "<p" + QByteArray::number(i) + ":x/>";
        QVERIFY(readText(bare(used)).error.contains("more than 100 prefixes"));
    }

    void allTogether()
    {
        const auto result = readText("\n" + QByteArray(declaration)
                                     + bare("<g inkscape:label='A&nbsp;B'><path d='M0 0h1'/></g>"));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->report.size(), std::size_t(3));
    }
};

} // namespace formats_svg_lenient_xml_test

TEST_CLASS(formats_svg_lenient_xml_test::LenientXmlTest, Core)
#include "tests/app/formats/svg/lenient_xml_test.moc"
