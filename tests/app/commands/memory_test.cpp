// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/history.h"
#include "app/commands/move_objects.h"
#include "app/commands/remove_objects.h"
#include "app/commands/set_style.h"

#include <QTest>

#include <malloc.h>

#include "tests/sanitizer.h"
#include "tests/app/document/sheet_edits.h"

namespace {

/// What the allocator has given, with what it adds.
std::size_t taken()
{
    const auto all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

app::Shape line(app::Point a, app::Point b)
{
    app::Shape shape;
    shape.paths.push_back({a, {{b}}, false});
    return shape;
}

/// Dashed polylines.
app::Sheet polylines(int count)
{
    app::Sheet sheet;
    for (int i = 0; i < count; ++i) {
        app::Shape shape = line({0, double(i)}, {1, double(i)});
        for (int j = 2; j < 40; ++j)
            shape.paths[0].segments.push_back({{double(j), double(i % j)}});
        shape.style.dashes = {4, 2};
        sheet.shapes.push_back(std::move(shape));
    }
    return sheet;
}

app::ObjectRanges all(const app::EditedDocument& document)
{
    return app::ObjectRanges(app::ObjectRange{0, document.now().objects().size()});
}

} // namespace

class MemoryTest : public QObject {
    Q_OBJECT

private slots:
    // What a step says is what the allocator gets back when it is forgotten, to 1 %.
    void aStepKeepsWhatItSays_data()
    {
        using Make = std::function<app::UndoCommand*(app::EditedDocument&)>;
        QTest::addColumn<Make>("make");
        QTest::newRow("move") << Make([](app::EditedDocument& document) {
            return new app::MoveObjects(document, all(document), {1, 1});
        });
        QTest::newRow("style") << Make([](app::EditedDocument& document) {
            return new app::SetStyle(
                document, all(document), [](app::Style& style) { style.dashes = {1}; }, "Dashes");
        });
        QTest::newRow("remove") << Make(
            [](app::EditedDocument& document) { return new app::RemoveObjects(document, all(document)); });
    }
    void aStepKeepsWhatItSays()
    {
        if (!memoryCanBeLimited)
            QSKIP("a sanitizer has an allocator of its own");
        QFETCH(std::function<app::UndoCommand*(app::EditedDocument&)>, make);
        app::EditedDocument document(app::documentOf(polylines(5000)));
        app::History history;
        history.push(make(document));
        const std::size_t said = history.bytes(), before = taken();
        history.clear();
        const std::size_t freed = before - taken();
        QVERIFY2(freed > 5'000'000 && std::abs(double(said) / double(freed) - 1) < 0.01,
                 qPrintable(QStringLiteral("%1 bytes, in truth %2").arg(said).arg(freed)));
    }

    // Shapes that go are kept by the step, and by the drawing again when it is undone.
    void aStepIsMeasuredAnewWhenItIsUndone()
    {
        app::EditedDocument document(app::documentOf(polylines(1000)));
        app::History history;
        history.push(new app::RemoveObjects(document, all(document)));
        const std::size_t inForce = history.bytes();
        QVERIFY(inForce > 1000 * 40 * sizeof(app::PathSegment));
        history.undo();
        QVERIFY(history.bytes() < 1000);
        history.redo();
        QCOMPARE(history.bytes(), inForce);
    }
};

QTEST_APPLESS_MAIN(MemoryTest)
#include "memory_test.moc"
