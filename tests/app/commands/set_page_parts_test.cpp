// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_page_parts.h"
#include "app/commands/set_style.h"
#include "app/document/document_builder.h"

#include <QTest>

#include "tests/test_class.h"

namespace commands_set_page_parts_test {

using namespace app;

namespace {

Object line(double y, double width, bool hidden = false)
{
    Object object{Path(clipping::Segment{{0, y}, {10, y}}), {.stroke = Colour{}, .width = width}};
    object.hidden = hidden;
    return object;
}

/// `lines` lines of three widths in turn, some of them hidden, and perhaps a curve.
Document drawing(int lines, int hiddenEach, bool curve)
{
    DocumentBuilder builder;
    builder.open({});
    for (int i = 0; i < lines; ++i)
        builder.add(line(i, 1 + i / 3 % 3, hiddenEach > 0 && i % hiddenEach == 0));
    if (curve) {
        const std::vector<Subpath> paths{{{0, 0}, {{{7, 1}, {5.5, 2}, {6.5, 8}, true}}, false}};
        builder.add(Object{Path(paths), {.stroke = Colour{}, .width = 5, .dashes = {2, 3}}});
    }
    builder.close();
    return builder.take({});
}

} // namespace

class SetPagePartsTest : public QObject {
    Q_OBJECT

private slots:
    void strokesStayAsWideOnPaper_data()
    {
        QTest::addColumn<int>("lines");
        QTest::addColumn<int>("hiddenEach");
        QTest::addColumn<bool>("curve");
        QTest::addRow("lines alone") << 20'000 << 0 << false;
        QTest::addRow("some hidden") << 20'000 << 7 << false;
        QTest::addRow("a curve among them") << 5'000 << 0 << true;
        QTest::addRow("nothing") << 0 << 0 << false;
    }
    void strokesStayAsWideOnPaper()
    {
        QFETCH(int, lines);
        QFETCH(int, hiddenEach);
        QFETCH(bool, curve);
        EditedDocument edited(drawing(lines, hiddenEach, curve));
        const Document before = edited.now();
        Page page = before.page();
        page.size = page.size * 4.0; // a unit is a fourth on paper
        const double factor = before.page().millimetresPerUnit() / page.millimetresPerUnit();
        QCOMPARE(factor, 4.0);
        ChangePage step(edited, page, std::nullopt);
        step.redo();
        const Objects& objects = edited.now().objects();
        QCOMPARE(objects.size(), before.objects().size());
        for (std::size_t i = 0; i < objects.size(); ++i) {
            Object expected = before.objects()[i].copy();
            scaleStroke(expected.style, factor);
            QVERIFY2(objects[i].copy() == expected, qPrintable(QString::number(i)));
        }
        step.undo();
        QVERIFY(edited.now() == before);
    }
};

} // namespace commands_set_page_parts_test

TEST_CLASS(commands_set_page_parts_test::SetPagePartsTest, Core)
#include "tests/app/commands/set_page_parts_test.moc"
