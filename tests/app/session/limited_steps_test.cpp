// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/layer_steps.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_limited_steps_test {

using namespace app;

namespace {

/// An empty drawing with so many containers.
Document drawing(std::size_t containers)
{
    DocumentBuilder builder;
    builder.open({.name = QStringLiteral("Drawing")});
    for (std::size_t i = 1; i < containers; ++i) {
        builder.open({.kind = Container::Kind::Group});
        builder.close();
    }
    builder.close();
    return builder.take({}, {}, {});
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
    void theLastLayerThatFitsIsAdded()
    {
        Asked session(drawing(Containers::mostContainers - 1));
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
        Asked session(drawing(Containers::mostContainers));
        const Document before = session.now();
        QVERIFY(!addLayer(session, "Sky"));
        QCOMPARE(session.now(), before);
        QCOMPARE(session.history.count(), 0);
        QCOMPARE(session.refusals.size(), 1);
        const QString sentence = session.refusals[0][0].toString();
        QVERIFY2(sentence.contains("has 100,000 layers and groups"), qPrintable(sentence));
    }
};

} // namespace session_limited_steps_test

TEST_CLASS(session_limited_steps_test::LimitedStepsTest, Core)
#include "tests/app/session/limited_steps_test.moc"
