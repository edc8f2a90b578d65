// SPDX-License-Identifier: GPL-3.0-or-later
// What a history of edits costs: the objects that went, not the documents that were.
#include "app/document/document_builder.h"
#include "app/document/edited_document.h"

#include <QTest>

#include <cmath>
#include <malloc.h>
#include <random>
#include <set>

#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace document_edit_memory_test {

using namespace app;

namespace {

constexpr std::size_t segments = 1'000'000, edits = 1000, objectsOfAnEdit = 100;
constexpr double mega = 1e6;

double heap() // in MB
{
    const auto info = ::mallinfo2();
    return double(info.uordblks + info.hblkhd) / mega;
}

Document loose()
{
    DocumentBuilder builder;
    const StyleEntry style = builder.style({.stroke = Colour{}});
    for (std::size_t i = 0; i < segments; ++i) {
        if (i % (segments / 10) == 0)
            builder.open({.name = QString::number(i)});
        builder.addLine({{double(i), 1}, {2, double(i)}}, style);
        if ((i + 1) % (segments / 10) == 0)
            builder.close();
    }
    return builder.take({});
}

Document polylines()
{
    DocumentBuilder builder;
    builder.open({});
    const StyleEntry style = builder.style({.stroke = Colour{}});
    for (std::size_t i = 0; i < segments / 100; ++i) {
        Subpath path{{0, double(i)}, {}, false};
        for (int n = 1; n <= 100; ++n)
            path.segments.push_back({{double(n), double(i) + std::sin(n)}});
        builder.add(ObjectRow{Path(std::span(&path, 1)), style});
    }
    builder.close();
    return builder.take({});
}

/// Makes edits of 100 objects, in one run, in ten, or each on its own.
class Edits {
public:
    explicit Edits(int everyScattered) : everyScattered_(everyScattered) {}

    Edit next(const Document& document)
    {
        ++made_;
        const std::size_t runs = made_ % everyScattered_ == 0 ? objectsOfAnEdit
                                 : made_ % 2                  ? 1
                                                              : 10;
        Edit edit{.objects = document.objects().slice(0, 0)};
        for (const std::size_t first : places(document.objects().size(), runs))
            add(edit, document, std::uint32_t(first), std::uint32_t(objectsOfAnEdit / runs));
        if (!edit.splices.empty() && edit.splices[0].removed != edit.splices[0].added)
            edit.containers = document.containers().spliced(edit.splices);
        return edit;
    }

private:
    // Where runs of the same length begin.
    std::set<std::size_t> places(std::size_t objects, std::size_t runs)
    {
        const std::size_t length = objectsOfAnEdit / runs;
        std::set<std::size_t> places;
        while (places.size() < runs)
            places.insert(random_() % (objects / length) * length);
        return places;
    }

    // Objects are moved, get another style, are hidden, deleted or doubled, in turn.
    void add(Edit& edit, const Document& document, std::uint32_t first, std::uint32_t count)
    {
        const int act = (made_ + made_ / everyScattered_) % 5; // all of them scattered, too
        const Placement right{{1, 1}, {10, -0.0}};
        const StyleEntry red = edit.objects.styles().entryOf({.stroke = Colour{255, 0, 0}});
        edit.splices.push_back({first, count, act == 3 ? 0 : act == 4 ? 2 * count : count});
        document.objects().forEach(first, count, [&](std::size_t, const ObjectView& object) {
            ObjectRow row = object.row();
            if (act == 0 || act == 4)
                row.path = row.path.placed(right);
            if (act == 1)
                row.style = red;
            if (act == 2)
                row.hidden = !row.hidden;
            if (act != 3)
                edit.objects.append(row);
            if (act == 4)
                edit.objects.append(object.row());
        });
    }

    std::mt19937_64 random_{1};
    int made_ = 0, everyScattered_;
};

} // namespace

class EditMemoryTest : public QObject {
    Q_OBJECT

private slots:
    void aThousandEdits_data()
    {
        QTest::addColumn<bool>("areLoose");
        QTest::newRow("loose lines") << true;
        QTest::newRow("polylines of 100 segments") << false;
    }
    // One edit in twenty is scattered over the whole document; all of them, if that is asked for.
    void aThousandEdits()
    {
        QFETCH(bool, areLoose);
        EditedDocument document(areLoose ? loose() : polylines());
        const bool all = qEnvironmentVariableIsSet("ALL_SCATTERED");
        Edits next(all ? 1 : 20);
        std::vector<Edit> history;
        history.reserve(edits);
        double own = 0;
        const double before = heap();
        for (std::size_t i = 0; i < edits; ++i) {
            const Edit edit = next.next(document.now());
            history.push_back(document.apply(edit));
            own += double(history.back().bytesNotIn(edit)) / mega;
        }
        const double after = heap();
        qInfo("1,000 edits of 100 objects: %.1f MB; their own %.1f MB", after - before, own);
        QVERIFY(own < 100);
        if (memoryCanBeLimited)
            QVERIFY(after - before < 100);

        for (; !history.empty(); history.pop_back())
            document.apply(history.back());
        QVERIFY(document.now() == (areLoose ? loose() : polylines()));
    }
};

} // namespace document_edit_memory_test

TEST_CLASS(document_edit_memory_test::EditMemoryTest, None)
#include "tests/app/document/edit_memory_test.moc"
