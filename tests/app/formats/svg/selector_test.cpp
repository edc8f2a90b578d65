// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/selector.h"

#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_selector_test {

using namespace app::svg;

namespace {

// The numbers of the lines with this selector, of six: "1 3".
QString chosen(const QByteArray& selector)
{
    const auto result = readText(drawing("<style><![CDATA[" + selector
                                         + "{stroke-width:9}]]></style><g id='all' class='outer'>"
                                           "<line x2='1' class='a thin' id='one' stroke='red'/>"
                                           "<line x2='2' class='b' data-kind='road-main'/>text"
                                           "<!-- no element --><line x2='3' class='a b'/>"
                                           "<g><line x2='4' class='c'/></g>"
                                           "<a href='#x'><line x2='5' class='A'/></a>"
                                           "<line x2='6' data-kind='Road'/></g>"));
    if (!result)
        return result.error;
    QStringList numbers;
    const app::Objects& objects = result.value->document.objects();
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i].style().width == 9)
            numbers << QString::number(i + 1);
    return numbers.join(' ');
}

int specificity(const char* text)
{
    const auto selector = parseSelector(text);
    return selector ? specificityOf(*selector) : -1;
}

} // namespace

class SelectorTest : public QObject {
    Q_OBJECT
private slots:
    void choose_data()
    {
        QTest::addColumn<QByteArray>("selector");
        QTest::addColumn<QString>("lines");
        const auto row = [](const char* selector, const char* lines) {
            QTest::newRow(selector) << QByteArray(selector) << lines;
        };
        row("line", "1 2 3 4 5 6");
        row("line:first-child", "1 4 5");
        row("line:last-child", "4 5 6");
        row("line:only-child", "4 5");
        row("line:nth-child(2)", "2");
        row("line:nth-child( 2N + 1 )", "1 3 4 5");
        row("line:nth-child(odd)", "1 3 4 5");
        row("line:nth-child(even)", "2 6");
        row("line:nth-child(-n+2)", "1 2 4 5");
        row("line:nth-child(n+3)", "3 6");
        row("line:nth-last-child(1)", "4 5 6");
        row("line:nth-of-type(4)", "6");
        row("line:first-of-type", "1 4 5");
        row("line:last-of-type", "4 5 6");
        row("line:only-of-type", "4 5");
        row("line:empty", "1 2 3 4 5 6");
        row("line + line", "2 3");
        row("line ~ line", "2 3 6");
        row(".a+.b", "2");
        row("g + a > line", "5");
        row("#one~g line", "4");
        row("line:not(.a)", "2 4 5 6");
        row("line:not(.a, .b)", "4 5 6");
        row("line:not(:first-child):not(.b)", "6");
        row(":is(.a, .c)", "1 3 4");
        row(":where(#one)", "1");
        row("line:is(g > .c, a .A)", "4 5");
        row("[stroke]", "1");
        row("[class~=b]", "2 3");
        row("[data-kind|='road']", "2");
        row("[data-kind^=\"Road\"]", "6");
        row("[data-kind$=main]", "2");
        row("[data-kind*='oad']", "2 6");
        row("[data-kind='road' i]", "6");
        row("a:link line", "5");
        row("line:hover", "");
        row("line:not(:hover)", "1 2 3 4 5 6");
        row(".outer > line.thin[stroke=red]:first-child", "1");
    }
    void choose()
    {
        QFETCH(const QByteArray, selector);
        QFETCH(const QString, lines);
        QCOMPARE(chosen(selector), lines);
    }

    void specificities()
    {
        QCOMPARE(specificity("#a .b c"), 0x010101);
        QCOMPARE(specificity("a:first-child"), 0x000101);
        QCOMPARE(specificity(":not(#a, .b)"), 0x010000);
        QCOMPARE(specificity(":is(a, .b.c)"), 0x000200);
        QCOMPARE(specificity(":where(#a)"), 0);
    }

    void whatIsNotUnderstoodIsTold()
    {
        for (const char* text : {"a:lang(en)", "a:nth-child(x)", "a:not()", "a >", "[", "a:has(b)",
                                 "a::part(b)", "svg|a", "[a=b", ":nth-child(2n+)"})
            QVERIFY2(!parseSelector(text), text);
        QCOMPARE(reportOf("<style>a:has(b){fill:red}</style>"), "1 style rule “a:has(b)”");
        QCOMPARE(reportOf("<style>a:hover, a::before{fill:red}</style>"), "");
    }

    void listsInBrackets()
    {
        QCOMPARE(selectorsIn("a:not(b, c), [d=','] , e").size(), std::size_t(3));
    }

    void longSelectorsEnd()
    {
        const QByteArray deep =
            QByteArray(":not(").repeated(20'000) + "a" + QByteArray(")").repeated(20'000);
        QVERIFY(!parseSelector(deep.toStdString()));
        const QByteArray wide = "a:not(" + QByteArray("b,").repeated(50'000) + "c)";
        QVERIFY(parseSelector(wide.toStdString()));
        const QByteArray many = QByteArray("g ").repeated(50'000) + "a";
        QVERIFY(parseSelector(many.toStdString()));
    }

    void importsOfData()
    {
        const auto width = [](const QByteArray& sheet) {
            return shapeOf("<style>" + sheet + "</style><line x2='1' stroke='red'/>").style.width;
        };
        QCOMPARE(width("@import url(data:text/css,line%7Bstroke-width:9%7D);"), 9.0);
        QCOMPARE(width("@import \"data:text/css;base64,bGluZXtzdHJva2Utd2lkdGg6OX0=\" screen;"),
                 9.0); // line{stroke-width:9}
        QCOMPARE(width("@import url(data:text/css,line%7Bstroke-width:9%7D) print;"), 1.0);
        QCOMPARE(reportOf("<style>@import 'other.css';</style>"),
                 "1 style rule “@import 'other.css'”");
    }

    void media_data()
    {
        QTest::addColumn<QByteArray>("media");
        QTest::addColumn<int>("applies"); // -1: told
        const auto row = [](const char* media, int applies) {
            QTest::newRow(media) << QByteArray(media) << applies;
        };
        row("screen and (prefers-color-scheme: light)", 1);
        row("(prefers-color-scheme:dark)", 0);
        row("not print", 1);
        row("not screen", 0);
        row("only screen", 1);
        row("print and (min-width: 9px)", 0);
        row("screen and (min-width: 9px)", -1);
        row("print, (prefers-reduced-motion: no-preference)", 1);
    }
    void media()
    {
        QFETCH(const QByteArray, media);
        QFETCH(const int, applies);
        const QByteArray elements =
            "<style>@media " + media + "{line{stroke-width:9}}</style><line x2='1' stroke='red'/>";
        QCOMPARE(shapeOf(elements).style.width, applies == 1 ? 9.0 : 1.0);
        QCOMPARE(reportOf(elements).isEmpty(), applies >= 0);
    }
};

} // namespace formats_svg_selector_test

TEST_CLASS(formats_svg_selector_test::SelectorTest, None)
#include "tests/app/formats/svg/selector_test.moc"
