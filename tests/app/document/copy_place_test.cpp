// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copies.h"
#include "app/document/document_builder.h"

#include <QTest>

#include "tests/test_class.h"

namespace document_copy_place_test {

using namespace app;

namespace {

Object line(const Point& a, const Point& b) { return {Path(clipping::Segment{a, b}), {}}; }

Object moved(Object object, const Point& by)
{
    object.path = object.path.placed({{1, 1}, by});
    return object;
}

Objects objectsOf(const std::vector<Object>& list)
{
    Objects objects;
    for (const Object& object : list)
        objects.append(object);
    return objects;
}

Document documentOf(const std::vector<Object>& list)
{
    DocumentBuilder builder;
    builder.open({});
    builder.add(objectsOf(list));
    builder.close();
    return builder.take({});
}

} // namespace

class CopyPlaceTest : public QObject {
    Q_OBJECT

private slots:
    void everyCopyHasAPlaceOfItsOwn()
    {
        const Point step(5.0 / 3);
        const std::vector<Subpath> curve{{{3, 3}, {{{4, 9}, {5, 5}, {6, 6}, true}}, true}};
        const std::vector<Object> copied{line({0.1, 0}, {10, 7}), {Path(curve), {}}};
        std::vector<Object> there;
        for (int copies = 1; copies <= 20; ++copies) {
            const Point offset = copyOffset(documentOf(there), objectsOf(copied), step);
            QCOMPARE(offset, double(copies) * step);
            for (const Object& object : copied)
                there.push_back(moved(object, offset));
        }
        there.erase(there.begin() + 6, there.begin() + 8); // the fourth copy
        QCOMPARE(copyOffset(documentOf(there), objectsOf(copied), step), 4.0 * step);
        there.push_back(moved(copied[1], 4.0 * step)); // one of them is enough
        QCOMPARE(copyOffset(documentOf(there), objectsOf(copied), step), 21.0 * step);
    }
    void onlyPathsCount()
    {
        Object there = line({5, 5}, {15, 12});
        there.style.width = 9;
        const Document document = documentOf({there});
        const auto offset = [&](const Object& copy) {
            return copyOffset(document, objectsOf({copy}), Point(5));
        };
        QCOMPARE(offset(line({0, 0}, {10, 7})), Point(10));
        QCOMPARE(offset(line({0, 0}, {10, 8})), Point(5));
        QCOMPARE(offset(Object()), Point(5));
    }
    void itEndsWhereAStepChangesNothing()
    {
        const std::vector<Object> there{line({1e30, 1e30}, {2e30, 1e30})};
        QCOMPARE(copyOffset(documentOf(there), objectsOf(there), Point(5)), Point(5000));
    }
};

} // namespace document_copy_place_test

TEST_CLASS(document_copy_place_test::CopyPlaceTest, Gui)
#include "tests/app/document/copy_place_test.moc"
