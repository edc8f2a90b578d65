// SPDX-License-Identifier: GPL-3.0-or-later
// Threads read snapshots while the document is edited.
#include "app/document/edited_document.h"

#include <QTest>

#include <atomic>
#include <bit>
#include <thread>

#include "tests/app/document/random_documents.h"
#include "tests/test_class.h"

namespace document_snapshot_test {

using namespace app;

namespace {

// Of all that an object says. Those of several objects are added up.
std::uint64_t sumOf(const ObjectView& object)
{
    std::uint64_t sum = std::bit_cast<std::uint64_t>(object.style().width);
    const auto mix = [&](std::uint64_t bits) { sum = (sum ^ bits) * 0x9e3779b97f4a7c15U; };
    object.path().forEachPoint([&](const Point& p) {
        mix(std::bit_cast<std::uint64_t>(p.x));
        mix(std::bit_cast<std::uint64_t>(p.y));
    });
    for (const QChar& letter : object.particulars().id)
        mix(letter.unicode());
    mix(object.hidden());
    return sum;
}

std::uint64_t sumOf(const Objects& objects)
{
    std::uint64_t sum = 0;
    objects.forEach(0, objects.size(),
                    [&](std::size_t, const ObjectView& object) { sum += sumOf(object); });
    return sum;
}

// The sum as it is stored in the document: as the name of a clip window.
ClipWindows stored(std::uint64_t sum) { return {{{.name = QString::number(sum)}}}; }

bool intact(const Document& document)
{
    const std::size_t count = document.objects().size();
    const Containers& containers = document.containers();
    return stored(sumOf(document.objects())) == document.windows() && containers.objects() == count
           && (count == 0
               || (containers.contains(containers.containerOf(count - 1))
                   && containers.hiddenRanges().size() <= count));
}

/// Looks at snapshots, new and older ones, until it is stopped.
class Reader {
public:
    Reader(const EditedDocument& document, const std::atomic<bool>& stop)
        : thread_([this, &document, &stop] {
              std::array<Document, 4> kept;
              kept.fill(document.snapshot());
              for (; !stop || looked < 4; ++looked) {
                  kept[looked % 4] = document.snapshot();
                  if (!intact(kept[looked % 4]) || !intact(kept[looked * 7 / 3 % 4]))
                      ++broken;
              }
          })
    {
    }
    void join() { thread_.join(); }

    std::atomic<std::size_t> looked{0}, broken{0};

private:
    std::thread thread_;
};

} // namespace

class SnapshotTest : public QObject {
    Q_OBJECT

private slots:
    void areReadWhileEditsGoOn()
    {
        RandomDocuments random(12);
        EditedDocument document(random.document(400));
        std::uint64_t sum = sumOf(document.now().objects());
        document.apply({.windows = stored(sum)});
        std::atomic<bool> stop{false};
        std::array<std::optional<Reader>, 4> readers;
        for (auto& reader : readers)
            reader.emplace(document, stop);

        std::vector<Edit> undo;
        const auto apply = [&](Edit edit) {
            for (const Splice& s : edit.splices)
                document.now().objects().forEach(
                    s.first, s.removed,
                    [&](std::size_t, const ObjectView& object) { sum -= sumOf(object); });
            sum += sumOf(edit.objects);
            edit.windows = stored(sum);
            return document.apply(edit);
        };
        for (int i = 0; i < 1500; ++i) {
            if (undo.size() > 20 && random.below(3) == 0) {
                apply(undo.back());
                undo.pop_back();
            } else {
                undo.push_back(apply(random.edit(document.now())));
            }
        }
        stop = true;
        for (auto& reader : readers)
            reader->join();
        for (auto& reader : readers) {
            QVERIFY(reader->looked >= 4);
            QCOMPARE(reader->broken.load(), std::size_t(0));
        }
        QVERIFY(intact(document.now()));
    }
};

} // namespace document_snapshot_test

TEST_CLASS(document_snapshot_test::SnapshotTest, None)
#include "tests/app/document/snapshot_test.moc"
