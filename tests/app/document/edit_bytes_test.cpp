// SPDX-License-Identifier: GPL-3.0-or-later
// What edits say that the history holds with them is what the allocator gets back.
#include "app/document/document_builder.h"

#include <QTest>

#include <malloc.h>
#include <random>

#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace document_edit_bytes_test {

using namespace app;

namespace {

std::size_t taken()
{
    const auto all = ::mallinfo2();
    return all.uordblks + all.hblkhd;
}

Path polyline(int n)
{
    Subpath path{{0, double(n)}, {}, false};
    for (int i = 1; i < 40; ++i)
        path.segments.push_back({{double(i), double(i % n)}});
    return Path(std::span(&path, 1));
}

/// 4,000 polylines, some described, in as many groups or in one layer, and 100 clip windows.
Document drawing(bool grouped)
{
    DocumentBuilder builder;
    builder.open({.name = QStringLiteral("Layer %1").arg(1)});
    for (int i = 0; i < 4000; ++i) {
        if (grouped)
            builder.open({.kind = Container::Kind::Group, .name = QString::number(i)});
        builder.add(Object{polyline(i + 1),
                           {.width = 1},
                           {.description = i % 4 ? "" : QStringLiteral("Line %1").arg(i)}});
        if (grouped)
            builder.close();
    }
    builder.close();
    ClipWindows windows;
    for (int i = 0; i < 100; ++i)
        windows.list.push_back({QString::number(i), PathShape{polyline(2)}});
    return builder.take({}, {}, windows);
}

/// The edits of a session, and what undoes them.
class Session {
public:
    explicit Session(bool grouped) : document_(drawing(grouped)) {}

    // Each does it to every `every`th object, from `first` on.
    void move(std::size_t first, std::size_t every)
    {
        change(first, every, [](ObjectRow& row) { row.path = row.path.placed({{1, 1}, {1, 0}}); });
    }
    void hide(std::size_t first, std::size_t every)
    {
        change(first, every, [](ObjectRow& row) { row.hidden = true; });
    }
    void describe(std::size_t first, std::size_t every)
    {
        change(first, every, [&](ObjectRow& row) {
            Particulars particulars = *row.particulars;
            particulars.description = QStringLiteral("Step %1").arg(steps_.size());
            row.particulars = Shared(particulars);
        });
    }
    void remove(std::size_t first, std::size_t every)
    {
        Edit edit;
        for (std::size_t i = first; i < document_.objects().size(); i += every)
            edit.splices.push_back({std::uint32_t(i), 1, 0});
        edit.containers = document_.containers().spliced(edit.splices);
        apply(edit);
    }
    void rename(std::size_t container)
    {
        const auto all = document_.containers().inOrder();
        Container changed = document_.containers()[all[container % all.size()]];
        changed.name = QStringLiteral("Name %1").arg(steps_.size());
        apply({.containers = document_.containers().with(changed)});
    }
    void group(std::size_t object)
    {
        const Containers& tree = document_.containers();
        const ContainerId around = tree.containerOf(object);
        apply({.containers = tree.inserted({.kind = Container::Kind::Group}, around, 0,
                                           {object, object + 1})});
    }
    void renameWindow(std::size_t i)
    {
        ClipWindows windows = document_.windows();
        windows.list[i].name += QStringLiteral(" (changed)");
        apply({.windows = windows});
    }

    void undo(std::size_t count)
    {
        for (std::size_t i = steps_.size(); i-- > steps_.size() - count;)
            apply(steps_[i]);
    }
    std::size_t size() const { return steps_.size(); }
    std::size_t saidOf(std::size_t first, std::size_t end) const
    {
        std::size_t sum = 0;
        for (std::size_t i = first; i < end; ++i)
            sum += steps_[i].bytes;
        return sum;
    }
    void forget(std::size_t first, std::size_t end)
    {
        for (std::size_t i = first; i < end; ++i)
            steps_[i] = {};
    }

private:
    struct Step {
        Edit edit;
        std::size_t bytes = 0;
    };

    void change(std::size_t first, std::size_t every, const auto& how)
    {
        Edit edit{.objects = document_.objects().slice(0, 0)};
        for (std::size_t i = first; i < document_.objects().size(); i += every) {
            ObjectRow row = document_.objects()[i].row();
            how(row);
            edit.splices.push_back({std::uint32_t(i), 1, 1});
            edit.objects.append(row);
        }
        apply(edit);
    }
    void apply(const Edit& edit)
    {
        steps_.emplace_back();
        steps_.back().edit = edit;
        apply(steps_.back());
    }
    void apply(Step& step)
    {
        Edit back = document_.apply(step.edit);
        step.bytes = back.bytesNotIn(step.edit);
        step.edit = std::move(back);
    }

    Document document_;
    std::vector<Step> steps_;
};

using Script = void (*)(Session&);

// The allocator keeps a few KiB for itself, of those that were freed last.
bool near(std::size_t said, std::size_t freed)
{
    return std::abs(double(said) - double(freed)) <= 0.01 * double(freed) + 40'000;
}

} // namespace

class EditBytesTest : public QObject {
    Q_OBJECT

private slots:
    void areWhatIsFreed_data()
    {
        QTest::addColumn<bool>("grouped");
        QTest::addColumn<Script>("script");
        QTest::newRow("moved often, then removed") << false << Script([](Session& session) {
            for (std::size_t i = 0; i < 20; ++i)
                session.move(i % 2, 2);
            session.remove(0, 1);
        });
        QTest::newRow("hidden, moved and removed bit by bit") << true << Script([](Session& s) {
            for (std::size_t i = 0; i < 15; ++i) {
                s.hide(i, 7 + i);
                s.move(i, 11 + i);
                s.remove(i, 20 + i);
            }
        });
        QTest::newRow("described and removed") << false << Script([](Session& session) {
            for (std::size_t i = 0; i < 10; ++i)
                session.describe(i, 5);
            session.remove(0, 2);
            session.describe(0, 1);
        });
        QTest::newRow("containers renamed") << true << Script([](Session& session) {
            for (std::size_t i = 0; i < 300; ++i)
                session.rename(i * i);
        });
        QTest::newRow("objects grouped") << false << Script([](Session& session) {
            for (std::size_t i = 0; i < 1000; ++i)
                session.group(i * i % 4000);
        });
        QTest::newRow("windows renamed") << false << Script([](Session& session) {
            for (std::size_t i = 0; i < 100; ++i)
                session.renameWindow(i);
        });
    }
    // The oldest half of the steps is forgotten, then what is undone, then the rest.
    void areWhatIsFreed()
    {
        if (!memoryCanBeLimited)
            QSKIP("a sanitizer has an allocator of its own");
        QFETCH(bool, grouped);
        QFETCH(Script, script);
        for (const bool undo : {false, true}) {
            Session session(grouped);
            script(session);
            const std::size_t all = session.size(), undone = undo ? all / 3 : 0;
            session.undo(undone);
            const std::size_t bounds[]{0, (all - undone) / 2, all - undone, all};
            for (int part = 0; part < 3; part = part == 0 ? 2 : part == 2 ? 1 : 3) {
                const std::size_t first = bounds[part], end = bounds[part + 1];
                const std::size_t said = session.saidOf(first, end), before = taken();
                session.forget(first, end);
                const std::size_t freed = before - taken();
                const auto text = QStringLiteral("part %1: %2 bytes, in truth %3").arg(part);
                QVERIFY2(near(said, freed), qPrintable(text.arg(said).arg(freed)));
            }
        }
    }
};

} // namespace document_edit_bytes_test

TEST_CLASS(document_edit_bytes_test::EditBytesTest, None)
#include "tests/app/document/edit_bytes_test.moc"
