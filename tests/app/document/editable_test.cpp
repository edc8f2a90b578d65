// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/hidden_objects.h"

#include <QTest>

#include <random>

#include "tests/app/document/sheet.h"
#include "tests/app/document/three_layers.h"
#include "tests/test_class.h"

namespace document_editable_test {

class EditableTest : public QObject {
    Q_OBJECT

private slots:
    void allThatMayBeEditedIsARangeALayer()
    {
        app::Sheet drawing = threeLayers(100'000);
        QCOMPARE(app::editableObjects(app::documentOf(drawing)),
                 app::ObjectRanges(app::ObjectRange{0, 300'000}));
        drawing.layers[1].locked = true;
        QCOMPARE(app::editableObjects(app::documentOf(drawing)).ranges().size(), std::size_t(2));
        drawing.layers[0].visible = false;
        QCOMPARE(app::editableObjects(app::documentOf(drawing)),
                 app::ObjectRanges(app::ObjectRange{200'000, 300'000}));
        QCOMPARE(app::editableObjects(app::Document()), app::ObjectRanges{});
    }
    void whatIsHiddenIsNotEditable()
    {
        std::mt19937_64 random(4);
        for (int round = 0; round < 200; ++round) {
            app::Sheet drawing = threeLayers(10);
            drawing.layers.insert(drawing.layers.begin() + 1, {"empty"});
            app::ObjectRanges expected;
            for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
                drawing.shapes[i].layer += drawing.shapes[i].layer > 0 ? 1 : 0;
                drawing.shapes[i].hidden = random() % 2 == 0;
                if (!drawing.shapes[i].hidden)
                    expected.insert(i);
            }
            QCOMPARE(app::editableObjects(app::documentOf(drawing)), expected);
        }
    }
};

} // namespace document_editable_test

TEST_CLASS(document_editable_test::EditableTest, None)
#include "tests/app/document/editable_test.moc"
