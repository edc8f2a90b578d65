// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/content_kind.h"
#include "app/formats/format.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace formats_content_kind_test {

/// A file whose name says another kind of content than it has.
class ContentKindTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString errorOf(const QString& name, const QByteArray& content)
    {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            return "cannot be written";
        file.close();
        return app::readFile(file.fileName()).error;
    }

private slots:
    void aWrongNameIsTold()
    {
        const QByteArray plan = "  0\r\nSECTION\r\n  2\r\nENTITIES\r\n", map = "{ \"type\": 1 }",
                         drawing = "<?xml version='1.0'?><svg/>";
        QVERIFY(errorOf("a.svg", "%PDF-1.7\n").endsWith("by its content it is a PDF document."));
        QVERIFY(errorOf("b.svg", plan)
                    .endsWith("by its content it is a DXF drawing. Give it the ending .dxf."));
        QVERIFY(errorOf("c.svg", map)
                    .endsWith("by its content it is a GeoJSON map. Give it the ending .geojson."));
        QVERIFY(errorOf("d.dxf", drawing).endsWith("Give it the ending .svg."));
        QVERIFY(errorOf("f.svg", "AC1027").endsWith("Give it the ending .dwg."));
        QVERIFY(errorOf("g.dxf", "AC1027").contains("DWG file")); // and how it is converted
        QVERIFY(errorOf("e.dxf", "\x89PNG\r\n").endsWith("it is a PNG picture."));
    }
    void aDamagedFileOfItsOwnKindIsNot()
    {
        QVERIFY(!errorOf("a.svg", "<svg><g").contains("by its content"));
        QVERIFY(!errorOf("b.geojson", "{\"type\":").contains("by its content"));
        QVERIFY(!errorOf("c.svg", "").contains("by its content"));
        QVERIFY(app::contentKind("0").name.isEmpty() && app::contentKind("").name.isEmpty());
    }
};

} // namespace formats_content_kind_test

TEST_CLASS(formats_content_kind_test::ContentKindTest, Core)
#include "tests/app/formats/content_kind_test.moc"
