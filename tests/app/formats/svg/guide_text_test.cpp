// SPDX-License-Identifier: GPL-3.0-or-later
// The guides of a document in its file.
#include <QTest>

#include <limits>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_guide_text_test {

namespace {

QByteArray textOf(const app::Guides& guides)
{
    app::Document document;
    app::Page page;
    page.guides = guides;
    document.apply({.page = page});
    return ::textOf(document);
}

QByteArray metadata(const QByteArray& elements)
{
    return "<metadata xmlns:c='urn:clearcut:1'>" + elements + "</metadata>";
}

std::vector<app::Guide> read(const QByteArray& elements)
{
    const auto result = readText(drawing(metadata(elements)));
    return result ? result.value->document.page().guides.list : std::vector<app::Guide>{};
}

} // namespace

class GuideTextTest : public QObject {
    Q_OBJECT

private slots:
    void guidesAreWrittenAndReadBack()
    {
        const app::Guides guides{{{0, 20}, {1, 1.0 / 3}, {0, -4e5}}};
        const QByteArray text = textOf(guides);
        QVERIFY(text.contains("<metadata><clearcut:guide x=\"20\"/><clearcut:guide y=\"0.333"));
        const auto back = readText(text);
        QVERIFY(back.value && back.value->document.page().guides == guides);
        QVERIFY(back.value->report.empty());
        QVERIFY(!textOf(app::Guides{}).contains("metadata"));
        const double nowhere = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!textOf(app::Guides{{{0, nowhere}}}).contains("guide"));
    }
    void badGuidesAreDroppedAndReported()
    {
        const QByteArray bad = "<c:guide/><c:guide x=''/><c:guide x='nan'/><c:guide y='1e999'/>"
                               "<c:guide x='7'/>";
        QCOMPARE(read(bad), (std::vector<app::Guide>{{0, 7}}));
        QVERIFY(reportOf(metadata(bad)).contains("4 guides without a finite x or y"));
    }
    void atMostAThousandAreRead()
    {
        QCOMPARE(read(QByteArray("<c:guide y='3'/>").repeated(1001)).size(), app::Guides::most);
        QVERIFY(reportOf(metadata(QByteArray("<c:guide y='3'/>").repeated(1001)))
                    .contains("guide beyond the first 1,000"));
    }
};

} // namespace formats_svg_guide_text_test

TEST_CLASS(formats_svg_guide_text_test::GuideTextTest, Core)
#include "tests/app/formats/svg/guide_text_test.moc"
