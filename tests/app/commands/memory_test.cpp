// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_and_remove.h"
#include "app/commands/history.h"
#include "app/commands/move_objects.h"
#include "app/commands/set_style.h"
#include "app/document/document_builder.h"

#include <QTest>

#include <malloc.h>

#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace commands_memory_test {

namespace {

/// What the allocator has given, with what it adds.
std::size_t taken()
{
    const auto all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

app::Document polylines(int count)
{
    app::DocumentBuilder builder;
    builder.open({});
    for (int i = 0; i < count; ++i) {
        app::Subpath path{{0, double(i)}, {}, false};
        for (int j = 1; j < 40; ++j)
            path.segments.push_back({{double(j), double(i % j)}});
        builder.add(app::Object{app::Path(std::span(&path, 1)), {}});
    }
    builder.close();
    return builder.take({});
}

app::ObjectRanges all(const app::EditedDocument& document)
{
    return app::ObjectRanges(app::ObjectRange{0, document.now().objects().size()});
}

} // namespace

class MemoryTest : public QObject {
    Q_OBJECT

private slots:
    // What the steps say is what the allocator gets back when they are forgotten, to 1 %. It keeps
    // a few KiB for itself.
    void stepsKeepWhatTheySay_data()
    {
        using Do = std::function<void(app::EditedDocument&, app::History&)>;
        QTest::addColumn<Do>("act");
        QTest::addColumn<int>("least"); // bytes for each object
        const Do move = [](app::EditedDocument& document, app::History& history) {
            history.push(new app::MoveObjects(document, all(document), {1, 1}));
        };
        const Do style = [](app::EditedDocument& document, app::History& history) {
            history.push(new app::SetStyle(
                document, all(document), [](app::Style& one) { one.dashes = {1}; }, "Dashes"));
        };
        const Do remove = [](app::EditedDocument& document, app::History& history) {
            history.push(new app::RemoveObjects(document, all(document)));
        };
        QTest::newRow("move") << move << 40;
        QTest::newRow("style") << style << 40;
        QTest::newRow("remove") << remove << 40 + 40 * 16;
        QTest::newRow("move, style, remove") // which share the points
            << Do([=](app::EditedDocument& document, app::History& history) {
                   move(document, history);
                   style(document, history);
                   remove(document, history);
               })
            << 3 * 40 + 40 * 16;
    }
    void stepsKeepWhatTheySay()
    {
        if (!memoryCanBeLimited)
            QSKIP("a sanitizer has an allocator of its own");
        QFETCH(std::function<void(app::EditedDocument&, app::History&)>, act);
        QFETCH(int, least);
        constexpr int count = 20'000;
        app::EditedDocument document(polylines(count));
        app::History history;
        act(document, history);
        const std::size_t said = history.bytes(), before = taken();
        history.clear();
        const std::size_t freed = before - taken();
        QVERIFY2(said > std::size_t(count) * std::size_t(least)
                     && std::abs(double(said) - double(freed)) < 0.01 * double(freed) + 40'000,
                 qPrintable(QStringLiteral("%1 bytes, in truth %2").arg(said).arg(freed)));
    }

    // Objects that go are kept by the step, and by the document again when it is undone.
    void aStepIsMeasuredAnewWhenItIsUndone()
    {
        app::EditedDocument document(polylines(1000));
        app::History history;
        history.push(new app::RemoveObjects(document, all(document)));
        const std::size_t inForce = history.bytes();
        QVERIFY(inForce > 1000 * 40 * sizeof(app::Point));
        history.undo();
        QVERIFY(history.bytes() < 2000);
        history.redo();
        QCOMPARE(history.bytes(), inForce);
    }
};

} // namespace commands_memory_test

TEST_CLASS(commands_memory_test::MemoryTest, None)
#include "tests/app/commands/memory_test.moc"
