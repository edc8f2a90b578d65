// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"
#include "app/session/layer_colour.h"
#include "app/session/selection_style.h"

#include <QBuffer>
#include <QTest>

#include "tests/app/recovery/recorded_drawing.h"
#include "tests/test_class.h"

namespace session_layer_colour_test {

using namespace app;

// The colour of a layer is that of new objects in it.
class LayerColourTest : public QObject {
    Q_OBJECT

private slots:
    void newObjectsGetItAndUndoTakesItBack()
    {
        Session session;
        session.pen.style.width = 3;
        const ContainerId layer = session.pen.layer;
        const Colour usual = *newStyle(session).stroke, red{200, 0, 0};
        QVERIFY(!layerColour(session.now(), layer));
        setLayerColour(session, layer, red);
        QVERIFY(layerColour(session.now(), layer) == red);
        QVERIFY(newStyle(session).stroke == red);
        QCOMPARE(newStyle(session).width, 3.0);
        QCOMPARE(session.history.undoText(), "Layer colour");
        setLayerColour(session, layer, red); // the same
        QCOMPARE(session.history.count(), 1);
        session.history.undo();
        QVERIFY(newStyle(session).stroke == usual);
        session.history.redo();
        setLayerColour(session, layer, std::nullopt);
        QVERIFY(!layerColour(session.now(), layer) && newStyle(session).stroke == usual);
    }
    void theRestOfTheLayersStyleStays()
    {
        Session session;
        Style style = newStyle(session);
        style.dashes = {4, 2};
        setLayerStyle(session, style);
        setLayerColour(session, session.pen.layer, Colour{0, 0, 200});
        QCOMPARE(newStyle(session).dashes, style.dashes);
        QVERIFY(newStyle(session).stroke == (Colour{0, 0, 200}));
    }
    void itIsSavedAndInTheJournal()
    {
        const QTemporaryDir folder;
        Session session;
        Journal journal(session.document, session.history, folder.path());
        const Colour green{0, 128, 0};
        setLayerColour(session, session.pen.layer, green);
        const auto colourIn = [](const Document& document) {
            return layerColour(document, document.containers().childrenOf(0).front());
        };
        QVERIFY(colourIn(replayed(journal.folder())->document) == green);
        const QString path = folder.filePath("x.svg");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(svgOf(session.now()));
        file.close();
        QVERIFY(colourIn(readFile(path).value->document) == green);
        journal.discard();
    }
};

} // namespace session_layer_colour_test

TEST_CLASS(session_layer_colour_test::LayerColourTest, Core)
#include "tests/app/session/layer_colour_test.moc"
