// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/layer_steps.h"
#include "app/session/rearrange_selection.h"
#include "app/session/units.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_layer_steps_test {

using namespace app;

class LayerStepsTest : public QObject {
    Q_OBJECT

    /// Layers a, b (with c and d), e, each with an object.
    struct Drawing : Session {
        Drawing()
        {
            DocumentBuilder builder;
            const auto open = [&](const char* name) {
                const ContainerId id = builder.open({.name = name});
                builder.add({Path(clipping::Segment{{double(id), 0}, {double(id), 1}}),
                             {.stroke = Colour{}}});
                return id;
            };
            a = open("a");
            builder.close();
            b = open("b");
            c = open("c");
            builder.close();
            d = open("d");
            builder.close();
            builder.close();
            e = open("e");
            builder.close();
            load({builder.take({}), {}});
        }
        /// "a b(c d) e", bottom to top, and the painting order.
        QString tree(ContainerId of = 0) const
        {
            QStringList names;
            for (const ContainerId id : now().containers().childrenOf(of)) {
                const QString inner = tree(id);
                names << now().containers()[id].name
                             + (inner.isEmpty() ? QString() : '(' + inner + ')');
            }
            return names.join(' ');
        }
        QString painted() const
        {
            QString order;
            for (std::size_t i = 0; i < now().objects().size(); ++i)
                order += now().containers()[ContainerId(now().objects()[i].singleLine()->a.x)].name;
            return order;
        }
        QString visible() const
        {
            QString names;
            for (const ContainerId id : now().containers().inOrder())
                if (now().containers()[id].visible)
                    names += now().containers()[id].name;
            return names;
        }
        ContainerId a = 0, b = 0, c = 0, d = 0, e = 0;
    };

private slots:
    // Menus ask while another drawing is loaded, in which the entered group does not exist.
    void newObjectsAlwaysHaveALayer()
    {
        Drawing drawing;
        drawing.pen.layer = drawing.e;
        drawing.select({3});
        groupSelection(drawing);
        drawing.entered.enter(groupAt(drawing, 3));
        QVERIFY(drawing.entered.id() != 0);
        int asked = 0;
        const auto ask = [&] {
            ++asked;
            QVERIFY(drawing.now().containers().contains(layerForNew(drawing)));
            QVERIFY(mayAddObjects(drawing));
            QVERIFY(!nameForNew(drawing).isEmpty());
        };
        connect(&drawing.document, &EditedDocument::changed, &drawing, ask);
        for (const auto signal : {&Session::previewChanged, &Session::selectionChanged,
                                  &Session::inspectedChanged, &Session::displayChanged})
            connect(&drawing, signal, &drawing, ask);
        connect(&drawing.scene, &Scene::outdated, &drawing, ask);
        drawing.load({Document(), {}});
        QVERIFY(asked > 0);
        QVERIFY(drawing.now().containers().contains(drawing.pen.layer));
    }
    void layersMoveWithTheirObjects()
    {
        Drawing drawing;
        drawing.select({4}); // in e
        moveLayer(drawing, drawing.a, LayerStep::Up);
        QCOMPARE(drawing.tree(), "b(c d) a e");
        QCOMPARE(drawing.painted(), "bcdae");
        QCOMPARE(drawing.selection(), (ObjectRanges{4}));
        moveLayer(drawing, drawing.e, LayerStep::Down);
        moveLayer(drawing, drawing.e, LayerStep::Down);
        QCOMPARE(drawing.tree(), "e b(c d) a");
        QCOMPARE(drawing.painted(), "ebcda");
        QCOMPARE(drawing.selection(), (ObjectRanges{0}));
        QCOMPARE(drawing.history.undoText(), "Move layer e");
        moveLayer(drawing, drawing.e, LayerStep::Down); // the lowest already
        QCOMPARE(drawing.history.count(), 3);
        for (int i = 0; i < 3; ++i)
            drawing.history.undo();
        QCOMPARE(drawing.tree(), "a b(c d) e");
    }
    void layersAreNested()
    {
        Drawing drawing;
        moveLayer(drawing, drawing.a, LayerStep::Inward);
        QCOMPARE(drawing.tree(), "b(a c d) e");
        moveLayer(drawing, drawing.a, LayerStep::Outward);
        QCOMPARE(drawing.tree(), "a b(c d) e");
        moveLayer(drawing, drawing.d, LayerStep::Up); // out of b
        QCOMPARE(drawing.tree(), "a b(c) d e");
        moveLayer(drawing, drawing.c, LayerStep::Down);
        QCOMPARE(drawing.tree(), "a c b d e");
        moveLayer(drawing, drawing.e, LayerStep::Inward); // there is none above it
        QCOMPARE(drawing.tree(), "a c b d e");
    }
    void aLayerDoesNotMoveIntoItself()
    {
        Drawing drawing;
        QSignalSpy refused(&drawing, &Session::refused);
        moveLayer(drawing, drawing.b, ContainerPlace{drawing.c});
        QCOMPARE(refused.count(), 1);
        QCOMPARE(drawing.history.count(), 0);
    }
    void oneLayerIsShownAlone()
    {
        Drawing drawing;
        showOnlyLayer(drawing, drawing.c);
        QCOMPARE(drawing.visible(), "bc");
        QCOMPARE(drawing.history.undoText(), "Show only layer c");
        showOnlyLayer(drawing, drawing.c);
        QCOMPARE(drawing.visible(), "abcde");
        showOnlyLayer(drawing, drawing.b);
        QCOMPARE(drawing.visible(), "bcd");
        showOnlyLayer(drawing, drawing.a);
        QCOMPARE(drawing.visible(), "a");
    }
};

} // namespace session_layer_steps_test

TEST_CLASS(session_layer_steps_test::LayerStepsTest, Core)
#include "tests/app/session/layer_steps_test.moc"
