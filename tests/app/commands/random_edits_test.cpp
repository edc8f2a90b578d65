// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of commands of all kinds, done, undone and done again.
#include "app/commands/history.h"
#include "app/scene/scene.h"

#include <QTest>

#include <cstring>

#include "tests/app/commands/random_commands.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace commands_random_edits_test {

using namespace app;

namespace {

constexpr int steps = 10'000, perFile = 500;

std::vector<clipping::Segment> segmentsOf(const SceneLines& lines)
{
    std::vector<clipping::Segment> all;
    for (const auto& run : lines.runs())
        all.insert(all.end(), run.segments.begin(), run.segments.end());
    return all;
}

/// Whether the scene, which has followed all edits, is as one that is made anew.
bool isUpToDate(const Scene& scene, const Document& document)
{
    const SceneLines anew = linesOf(document.objects(), document.containers().hiddenRanges(),
                                    usualTolerance(document.page()));
    const auto has = segmentsOf(scene.lines()), expected = segmentsOf(anew);
    if (has.size() != expected.size()
        || (!has.empty() && std::memcmp(has.data(), expected.data(), has.size() * sizeof has[0])))
        return false;
    for (std::size_t i = 0; i <= document.objects().size(); ++i)
        if (scene.lines().firstLineOf(i) != anew.firstLineOf(i))
            return false;
    return true;
}

} // namespace

class RandomEditsTest : public QObject {
    Q_OBJECT

private slots:
    void areUndoneAndRedone()
    {
        EditedDocument document(RandomDocuments(1).document(300));
        const Scene scene(document);
        History history;
        RandomCommands commands(document, 2);
        const Document first = document.now();
        std::vector<QByteArray> files{textOf(first)};
        std::size_t objects = 0, windows = 0; // of all steps
        for (int i = 1; i <= steps; ++i) {
            history.push(commands.next());
            objects += document.now().objects().size();
            windows += document.now().windows().list.size();
            if (i % 100 == 0)
                QVERIFY2(isUpToDate(scene, document.now()), qPrintable(QString::number(i)));
            if (i % perFile == 0)
                files.push_back(textOf(document.now()));
        }
        QVERIFY2(commands.neverDrawn().empty(), commands.neverDrawn().data());
        QCOMPARE(history.count(), steps);
        QVERIFY(objects > 100 * steps && windows > 2 * steps);
        QVERIFY(history.bytes() < History::usualLimit / 2);

        const Document last = document.now();
        const auto isAsItWas = [&](std::size_t file) {
            history.setIndex(int(file) * perFile);
            return textOf(document.now()) == files[file] && isUpToDate(scene, document.now());
        };
        for (std::size_t file = files.size(); file-- > 0;)
            QVERIFY2(isAsItWas(file), qPrintable(QString::number(file)));
        QVERIFY(document.now() == first);
        for (std::size_t file = 1; file < files.size(); ++file)
            QVERIFY2(isAsItWas(file), qPrintable(QString::number(file)));
        QVERIFY(document.now() == last);
        qInfo("%d steps, %zu objects, %.1f MB", steps, objects / steps,
              double(history.bytes()) / 1e6);
    }
};

} // namespace commands_random_edits_test

TEST_CLASS(commands_random_edits_test::RandomEditsTest, Core)
#include "tests/app/commands/random_edits_test.moc"
