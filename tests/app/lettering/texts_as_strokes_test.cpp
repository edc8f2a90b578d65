// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/stroke_fonts.h"
#include "app/lettering/texts_as_strokes.h"

#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace lettering_texts_as_strokes_test {

namespace {

app::Document documentOf(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? result.value->document : app::Document();
}

struct Extent {
    double left = 1e9, right = -1e9;
};
Extent extentOf(const app::ObjectView& object)
{
    Extent extent;
    object.path().forEachPoint([&](const app::Point& p) {
        extent.left = std::min(extent.left, p.x);
        extent.right = std::max(extent.right, p.x);
    });
    return extent;
}

} // namespace

class TextsAsStrokesTest : public QObject {
    Q_OBJECT
private slots:
    void textsBecomeStrokesInTheirPlaces()
    {
        for (const char* text : {"Wide letters", "illi"}) {
            app::Document document = documentOf(
                "<path d='M0 0H5'/><text x='50' y='40' text-anchor='middle' font-size='8' "
                "fill='red'>"
                + QByteArray(text) + "</text>");
            QCOMPARE(document.objects().size(), std::size_t(2));
            const Extent before = extentOf(document.objects()[1]);
            document.apply(app::textsAsStrokes(document));
            QCOMPARE(document.objects().size(), std::size_t(2));
            const Extent after = extentOf(document.objects()[1]);
            QVERIFY(after.right - after.left <= before.right - before.left + 1e-9);
            QVERIFY(std::abs(after.left + after.right - before.left - before.right) < 1e-6);
            const app::Style style = document.objects()[1].style();
            QVERIFY(!style.fill && style.stroke && style.stroke->red == 255);
            const app::Recipe recipe = document.objects()[1].particulars().recipe;
            QCOMPARE(std::get<app::TextRecipe>(recipe).font, app::strokeFonts().front().name);
            QCOMPARE(std::get<app::TextRecipe>(recipe).text, text);
        }
    }

    void otherObjectsStay()
    {
        const app::Document document = documentOf("<path d='M0 0H5'/>");
        QVERIFY(app::textsAsStrokes(document).splices.empty());
        app::Document strokes = documentOf("<text>a</text>");
        strokes.apply(app::textsAsStrokes(strokes));
        QVERIFY(app::textsAsStrokes(strokes).splices.empty()); // they are strokes already
    }
};

} // namespace lettering_texts_as_strokes_test

TEST_CLASS(lettering_texts_as_strokes_test::TextsAsStrokesTest, Gui)
#include "tests/app/lettering/texts_as_strokes_test.moc"
