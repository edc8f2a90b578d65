// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/document/flattened.h"

#include <QTest>

#include "tests/test_class.h"

namespace document_flattened_test {

using namespace app;

class FlattenedTest : public QObject {
    Q_OBJECT

private slots:
    void onlyCurvesChange()
    {
        const std::vector<Subpath> straight{{{0, 0}, {{{1, 0}}, {{1, 1}}}, true}};
        const std::vector<Subpath> curved{{{0, 0}, {{{9, 0}, {3, 9}, {6, 9}, true}}, true},
                                          {{5, 5}, {}, false}};
        DocumentBuilder builder;
        builder.open({.name = "layer"});
        builder.add(Object{Path(straight), {.width = 2}});
        builder.add(Object{Path(curved), {.width = 3}, {.id = "c"}, true});
        builder.close();
        const Document document = builder.take({});
        const Document flat = flattened(document, 0.01);
        QCOMPARE(flat.objects().size(), 2u);
        QVERIFY(flat.objects()[0].copy() == document.objects()[0].copy());
        const Object object = flat.objects()[1].copy();
        QVERIFY(object.path.straight() && object.hidden);
        QCOMPARE(object.particulars.id, "c");
        QCOMPARE(object.style.width, 3.0);
        const auto subpaths = object.path.subpaths();
        QCOMPARE(subpaths.size(), 2u);
        QVERIFY(subpaths[0].closed && subpaths[0].segments.size() > 5);
        QCOMPARE(subpaths[0].segments.back().to, Point(9, 0)); // the closing line is implied
        QCOMPARE(subpaths[1], curved[1]);
    }
};

} // namespace document_flattened_test

TEST_CLASS(document_flattened_test::FlattenedTest, None)
#include "tests/app/document/flattened_test.moc"
