// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/clipboard.h"

#include <QTest>

#include <glm/geometric.hpp>

class ClipboardTest : public QObject {
    Q_OBJECT

private slots:
    void pasteReturnsTheCopyBitForBit()
    {
        app::DocumentBuilder builder;
        builder.open({.name = "one"});
        for (int i = 0; i < 3; ++i) {
            const std::vector<app::Subpath> subpaths{
                {{0.1 * i, 1.0 / 3}, {{{5, 5}}, {{7, 1}, {5.5, 2}, {6.5, 8}, true}}, i == 1}};
            app::Object object{app::Path(subpaths), {.stroke = app::Colour{1, 2, 3}, .width = 0.7}};
            object.particulars.id = QStringLiteral("o%1").arg(i);
            builder.add(object);
        }
        builder.close();
        const app::Document document = builder.take({});
        const auto data = app::copied(document, {0, 2});
        const app::Objects objects = app::pasted(*data, document.page()).objects();
        QCOMPARE(objects.size(), std::size_t(2));
        QVERIFY(objects[0].path() == document.objects()[0].path());
        QVERIFY(objects[0].style() == document.objects()[0].style());
        QVERIFY(objects[1].path() == document.objects()[2].path());
        QVERIFY(objects[1].particulars().id.isEmpty()); // the original has it
    }
    void anotherPageKeepsTheSizeOnPaper()
    {
        QMimeData data;
        data.setText("<svg xmlns='http://www.w3.org/2000/svg' width='10cm' height='10cm' "
                     "viewBox='0 0 10 10'>"
                     "<line x1='1' y1='2' x2='3' y2='2' stroke='red' stroke-width='0.5'/></svg>");
        const app::Page millimetres; // 297 mm and as many units
        const app::Objects objects = app::pasted(data, millimetres).objects();
        QCOMPARE(objects.size(), std::size_t(1));
        QVERIFY(glm::distance(objects[0].singleLine()->a, {10, 20}) < 1e-9);
        QVERIFY(std::abs(objects[0].style().width - 5) < 1e-9);
    }
    void otherClipboardContentsAreIgnored()
    {
        QMimeData data;
        data.setText("hello <svg but not really");
        QVERIFY(app::pasted(data, {}).objects().empty());
        data.setText("hello");
        QVERIFY(app::pasted(data, {}).objects().empty());
    }
};

QTEST_GUILESS_MAIN(ClipboardTest)
#include "clipboard_test.moc"
