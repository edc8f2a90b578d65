// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/clipboard.h"

#include <QTest>

#include <glm/geometric.hpp>

class ClipboardTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsCopiedIsPastedBitForBit()
    {
        app::Sheet sheet;
        for (int i = 0; i < 3; ++i) {
            app::Shape shape;
            shape.paths.push_back(
                {{0.1 * i, 1.0 / 3}, {{{5, 5}}, {{7, 1}, {5.5, 2}, {6.5, 8}, true}}, i == 1});
            shape.style.stroke = app::Colour{1, 2, 3};
            shape.style.width = 0.7;
            sheet.shapes.push_back(shape);
        }
        const auto data = app::copied(sheet, {0, 2});
        const auto shapes = app::pasted(*data, sheet.page, 0);
        QCOMPARE(shapes.size(), std::size_t(2));
        QVERIFY(shapes[0].paths == sheet.shapes[0].paths
                && shapes[0].style == sheet.shapes[0].style);
        QVERIFY(shapes[1].paths == sheet.shapes[2].paths);
    }
    void anotherPageKeepsTheSizeOnPaper()
    {
        QMimeData data;
        data.setText("<svg xmlns='http://www.w3.org/2000/svg' width='10cm' height='10cm' "
                     "viewBox='0 0 10 10'>"
                     "<line x1='1' y1='2' x2='3' y2='2' stroke='red' stroke-width='0.5'/></svg>");
        const app::Page millimetres; // 297 mm and as many units
        const auto shapes = app::pasted(data, millimetres, 0);
        QCOMPARE(shapes.size(), std::size_t(1));
        QVERIFY(glm::distance(shapes[0].paths[0].start, {10, 20}) < 1e-9);
        QVERIFY(std::abs(shapes[0].style.width - 5) < 1e-9);
    }
    void anythingElseIsNothing()
    {
        QMimeData data;
        data.setText("hello <svg but not really");
        QVERIFY(app::pasted(data, {}, 0).empty());
        data.setText("hello");
        QVERIFY(app::pasted(data, {}, 0).empty());
    }
};

QTEST_GUILESS_MAIN(ClipboardTest)
#include "clipboard_test.moc"
