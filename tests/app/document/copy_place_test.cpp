// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copy_place.h"
#include "app/document/path_points.h"

#include <QTest>

using namespace app;

class CopyPlaceTest : public QObject {
    Q_OBJECT

private slots:
    void everyCopyHasAPlaceOfItsOwn()
    {
        const Point step(5.0 / 3);
        const std::vector<Shape> copied{line({0.1, 0}, {10, 7}), line({3, 3}, {4, 9})};
        Sheet sheet;
        for (int copies = 1; copies <= 20; ++copies) {
            const Point offset = copyOffset(sheet, copied, step);
            QCOMPARE(offset, double(copies) * step);
            for (const Shape& shape : copied)
                sheet.shapes.push_back(moved(shape, offset));
        }
        sheet.shapes.erase(sheet.shapes.begin() + 6, sheet.shapes.begin() + 8); // the fourth copy
        QCOMPARE(copyOffset(sheet, copied, step), 4.0 * step);
        sheet.shapes.push_back(moved(copied[1], 4.0 * step)); // one of them is enough
        QCOMPARE(copyOffset(sheet, copied, step), 21.0 * step);
    }
    void onlyPathsCount()
    {
        Sheet sheet;
        sheet.shapes = {line({5, 5}, {15, 12})};
        sheet.shapes[0].style.width = 9;
        QCOMPARE(copyOffset(sheet, {line({0, 0}, {10, 7})}, Point(5)), Point(10));
        QCOMPARE(copyOffset(sheet, {line({0, 0}, {10, 8})}, Point(5)), Point(5));
        QCOMPARE(copyOffset(sheet, {Shape()}, Point(5)), Point(5));
    }
    void itEndsWhereAStepChangesNothing()
    {
        Sheet sheet;
        sheet.shapes = {line({1e30, 0}, {2e30, 0})};
        sheet.shapes[0].paths[0].start.y = 1e30;
        sheet.shapes[0].paths[0].segments[0].to.y = 1e30;
        QCOMPARE(copyOffset(sheet, sheet.shapes, Point(5)), Point(5000));
    }

private:
    static Shape moved(Shape shape, const Point& by)
    {
        for (Subpath& path : shape.paths)
            forEachPoint(path, [&](Point& point) { point += by; });
        return shape;
    }
    static Shape line(const Point& a, const Point& b)
    {
        Shape shape;
        shape.paths.push_back({a, {{b}}, false});
        return shape;
    }
};

QTEST_MAIN(CopyPlaceTest)
#include "copy_place_test.moc"
