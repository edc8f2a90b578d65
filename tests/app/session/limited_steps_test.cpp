// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/limited_steps.h"

#include <QSignalSpy>
#include <QTest>

using namespace app;

namespace {

const clipping::Window box{{1, 2}, {3, 4}};

/// An empty drawing with so many clip windows, which are hidden, and so many containers.
Document drawing(std::size_t windows, std::size_t containers)
{
    DocumentBuilder builder;
    builder.open({.name = QStringLiteral("Drawing")});
    for (std::size_t i = 1; i < containers; ++i) {
        builder.open({.kind = Container::Kind::Group});
        builder.close();
    }
    builder.close();
    ClipWindows list;
    list.list.resize(windows, {.shape = RectangleShape{}, .visible = false});
    return builder.take({}, {}, list);
}

/// A session that collects what it refuses.
struct Asked : Session {
    explicit Asked(Document drawing) { load({std::move(drawing), {}}); }
    QSignalSpy refusals{this, &Session::refused};
};

} // namespace

class LimitedStepsTest : public QObject {
    Q_OBJECT

private slots:
    void theLastClipWindowThatFitsIsDrawn()
    {
        Asked session(drawing(ClipWindows::most - 1, 1));
        placeClipWindow(session, box);
        QCOMPARE(session.now().windows().list.size(), ClipWindows::most);
        QCOMPARE(session.clipWindow(), std::optional(box));
        placeClipWindow(session, {{0, 0}, {9, 9}}); // there is one now: it moves
        QCOMPARE(session.clipWindow(), std::optional(clipping::Window{{0, 0}, {9, 9}}));
        QCOMPARE(session.history.count(), 2);
        QCOMPARE(session.refusals.size(), 0);
    }
    void oneClipWindowMoreIsRefused()
    {
        Asked session(drawing(ClipWindows::most, 1));
        const Document before = session.now();
        placeClipWindow(session, box);
        QCOMPARE(session.now(), before);
        QCOMPARE(session.history.count(), 0); // a step that does nothing would be none
        QCOMPARE(session.refusals.size(), 1);
        const QString sentence = session.refusals[0][0].toString();
        QVERIFY2(sentence.contains("has 1,000 clip windows"), qPrintable(sentence));
    }
    void theLastLayerThatFitsIsAdded()
    {
        Asked session(drawing(0, Containers::mostContainers - 1));
        QVERIFY(addLayer(session, "Sky"));
        const Containers& containers = session.now().containers();
        QCOMPARE(containers.size(), Containers::mostContainers);
        QCOMPARE(containers[containers.childrenOf(0).back()].name, "Sky");
        QCOMPARE(session.refusals.size(), 0);
    }
    void aLayerThatAFileWouldMergeIsRefused()
    {
        DocumentBuilder builder;
        for (std::size_t i = 0; i + 1 < Containers::mostLayers; ++i) {
            builder.open({.name = QString::number(i)});
            builder.close();
        }
        Asked session(builder.take({}, {}, {}));
        QVERIFY(addLayer(session, "last"));
        QVERIFY(!addLayer(session, "too many"));
        QCOMPARE(session.now().containers().size(), Containers::mostLayers);
        QCOMPARE(session.refusals.size(), 1);
        const QString sentence = session.refusals[0][0].toString();
        QVERIFY2(sentence.contains("has 1,000 layers"), qPrintable(sentence));
    }
    void oneLayerMoreIsRefused()
    {
        Asked session(drawing(0, Containers::mostContainers));
        const Document before = session.now();
        QVERIFY(!addLayer(session, "Sky"));
        QCOMPARE(session.now(), before);
        QCOMPARE(session.history.count(), 0);
        QCOMPARE(session.refusals.size(), 1);
        const QString sentence = session.refusals[0][0].toString();
        QVERIFY2(sentence.contains("has 100,000 layers and groups"), qPrintable(sentence));
    }
};

QTEST_GUILESS_MAIN(LimitedStepsTest)
#include "limited_steps_test.moc"
