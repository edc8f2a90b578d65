// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/convert_selection.h"
#include "app/session/session.h"

#include <QElapsedTimer>
#include <QTest>

#include "tests/test_class.h"

namespace session_convert_selection_test {

using namespace app;

class ConvertSelectionTest : public QObject {
    Q_OBJECT

    /// So many lines with ids, and above them a text.
    struct Drawing : Session {
        explicit Drawing(std::size_t lines)
        {
            DocumentBuilder builder;
            builder.open({.name = "Drawing"});
            const Path path(clipping::Segment{{0, 0}, {1, 1}});
            for (std::size_t i = 0; i < lines; ++i)
                builder.add({path, {}, {.id = QString::number(i)}});
            builder.add({path, {}, {.recipe = TextRecipe{"L", "sans", 5, {0, 0}}}});
            builder.close();
            load({builder.take({}), {}});
        }
    };

private slots:
    // The menu is grey exactly if nothing would happen, however many objects are selected.
    void itIsRefusedExactlyIfNothingWouldChange()
    {
        for (const std::size_t lines : {0, 3, 20'000}) {
            Drawing drawing(lines);
            QVERIFY(!convertRefusal(drawing).isEmpty()); // nothing is selected
            drawing.select(ObjectRanges(ObjectRange{0, lines}));
            QVERIFY(!convertRefusal(drawing).isEmpty());
            convertToPaths(drawing);
            QCOMPARE(drawing.history.count(), 0);
            drawing.select(ObjectRanges(ObjectRange{0, lines + 1}));
            QVERIFY(convertRefusal(drawing).isEmpty());
            convertToPaths(drawing);
            QCOMPARE(drawing.history.count(), 1);
            QVERIFY(!convertRefusal(drawing).isEmpty());
        }
    }
    void itIsQuick()
    {
        constexpr std::size_t lines = 300'000;
        Drawing drawing(lines);
        drawing.select(ObjectRanges(ObjectRange{0, lines}));
        QElapsedTimer clock;
        clock.start();
        QVERIFY(!convertRefusal(drawing).isEmpty());
        qInfo("%.1f ms for %zu objects with ids", 1e-6 * double(clock.nsecsElapsed()), lines);
    }
};

} // namespace session_convert_selection_test

TEST_CLASS(session_convert_selection_test::ConvertSelectionTest, None)
#include "tests/app/session/convert_selection_test.moc"
