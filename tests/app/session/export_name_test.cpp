// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/export_name.h"

#include "tests/test_class.h"

namespace session_export_name_test {

using namespace app;

// What the name of an exported file says.
class ExportNameTest : public QObject {
    Q_OBJECT

    static Document withLayer(const QString& name)
    {
        DocumentBuilder builder;
        builder.open({.name = name});
        builder.add({Path(clipping::Segment{{0, 0}, {1, 1}}), {.stroke = Colour{}}});
        builder.close();
        return builder.take({});
    }
    static QString ofLayer(const QString& name)
    {
        const Document document = withLayer(name);
        return exportName(
            {.part = ExportPart::Layer, .layer = document.containers().childrenOf(0).front()},
            document);
    }

private slots:
    void theAreaIsNamed()
    {
        const Document document = withLayer("Walls");
        QCOMPARE(exportName({.part = ExportPart::Cut}, document), QString("-cut"));
        QCOMPARE(exportName({.part = ExportPart::Page}, document), QString("-page"));
        QCOMPARE(exportName({.part = ExportPart::Selection}, document), QString("-selection"));
        QCOMPARE(exportName({.part = ExportPart::Window, .window = 7}, document),
                 QString("-window"));
        QCOMPARE(exportName({.part = ExportPart::Layer, .layer = 12345}, document),
                 QString("-layer"));
    }
    void aLayerGivesItsNameAsFarAsAFileMayHaveIt()
    {
        QCOMPARE(ofLayer("Ground floor (2)"), QString("-Ground floor (2)"));
        QCOMPARE(ofLayer("../etc/pass\nwd\t*?"), QString("-..-etc-pass-wd---"));
        QCOMPARE(ofLayer("   "), QString("-layer"));
        QCOMPARE(ofLayer(QString(10000, 'x')).size(), qsizetype(61));
    }
};

} // namespace session_export_name_test

TEST_CLASS(session_export_name_test::ExportNameTest, Core)
#include "tests/app/session/export_name_test.moc"
