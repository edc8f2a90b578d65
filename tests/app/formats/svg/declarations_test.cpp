// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"
#include "app/formats/svg/style_text.h"

#include <QBuffer>
#include <QTest>

#include "tests/app/document/random_documents.h"
#include "tests/app/formats/lossy.h"
#include "tests/test_class.h"

namespace formats_svg_declarations_test {

using app::Colour;
using app::Style;

// Styles as CSS declarations, as a layer holds the style of its new objects.
class DeclarationsTest : public QObject {
    Q_OBJECT

private slots:
    void declarationsAreReadable()
    {
        QCOMPARE(app::svg::declarations({.stroke = Colour{255, 0, 0}, .width = 2}),
                 QString("fill:none;stroke:#ff0000;stroke-width:2"));
    }
    void everyVisibleStyleIsReadBack()
    {
        RandomDocuments random(3);
        int read = 0;
        for (int i = 0; i < 500; ++i) {
            const Style style = random.style();
            const QString text = app::svg::declarations(style);
            const auto back = app::svg::styleOf(text);
            if (!back)
                continue;
            ++read;
            QVERIFY2(app::svg::declarations(*back) == text, qPrintable(text));
        }
        QVERIFY(read > 250);
    }
    void otherTextIsHarmless()
    {
        for (const char* text :
             {"</svg>", "\"/><path d='M0 0H9'/>", "&amp;", "stroke:", "fill:url(#x)"})
            if (const auto style = app::svg::styleOf(text))
                QVERIFY2(!style->stroke, text);
        QVERIFY(!app::svg::styleOf(QString(20'000, u'x')));
    }
    void layerKeepsItsStyleInAFile()
    {
        const QString text =
            app::svg::declarations({.stroke = Colour{0, 0, 255}, .dashes = {2, 1}});
        app::DocumentBuilder builder;
        builder.open({.name = "Ink", .newStyle = text});
        builder.close();
        builder.open({.name = "Plain"});
        builder.close();
        QBuffer file;
        file.open(QIODevice::ReadWrite);
        QVERIFY(!app::formats().front().write(builder.take({}), file, {}));
        QVERIFY(file.data().contains("clearcut:new-objects=\"fill:none;stroke:#0000ff;"));
        file.seek(0);
        const auto read = app::formats().front().read(file);
        QVERIFY(read && !isLossy(*read.value));
        const app::Containers& layers = read.value->document.containers();
        QCOMPARE(layers[layers.childrenOf(0)[0]].newStyle, text);
        QVERIFY(layers[layers.childrenOf(0)[1]].newStyle.isEmpty());
    }
};

} // namespace formats_svg_declarations_test

TEST_CLASS(formats_svg_declarations_test::DeclarationsTest, Core)
#include "tests/app/formats/svg/declarations_test.moc"
