// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"
#include "app/recovery/unsaved_work.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>

#include "tests/app/document/sheet.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/replaced_heap.h"
#include "tests/test_class.h"

namespace {

std::atomic<std::size_t> allocations{0};

} // namespace

// Counts what the program takes from the heap.
bool heapRefuses(std::size_t)
{
    ++allocations;
    return false;
}

using namespace app;

namespace {

Shape line(double x, std::uint32_t layer)
{
    Shape shape;
    shape.paths.push_back({{x, 0.1}, {{{x, 7}}}, false});
    shape.style.stroke = Colour{1, 2, 3};
    shape.layer = layer;
    return shape;
}

/// Three layers of so many lines; one of them is empty.
Sheet sheetOf(int lines)
{
    Sheet sheet;
    sheet.layers = {{"Ground"}, {"Hidden", false, false}, {"Empty"}, {"Locked", true, true}};
    for (const std::uint32_t layer : {0U, 1U, 3U})
        for (int i = 0; i < lines; ++i)
            sheet.shapes.push_back(line(i, layer));
    return sheet;
}

PendingObject inHand(const EditedDocument& document, const Shape& shape)
{
    return {{.path = Path(shape.paths), .style = shape.style},
            document.now().containers().childrenOf(0)[shape.layer]};
}

} // namespace

class UnsavedWorkTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    UnsavedWork::Document document(bool changed) const
    {
        return {folder_.filePath("unsaved/x.svg"), {"x", {}, {}}, {}, changed, {}};
    }

private slots:
    void theShapeInHandIsTheLastOfItsLayer()
    {
        for (const int lines : {0, 1, 3})
            for (std::uint32_t layer = 0; layer < 4; ++layer)
                for (const bool changed : {false, true}) {
                    const EditedDocument edited(documentOf(sheetOf(lines)));
                    UnsavedWork work(edited);
                    auto known = document(changed);
                    Shape added = line(-5, layer);
                    added.style.dashes = {1, 2};
                    known.inHand = inHand(edited, added);
                    work.tell(known);
                    const auto written = work.write();
                    QVERIFY2(written.unsaved && !written.error, qPrintable(*written.error));
                    Sheet expected = app::sheetOf(edited.now());
                    const auto end =
                        std::ranges::upper_bound(expected.shapes, layer, {}, &Shape::layer);
                    expected.shapes.insert(end, added);
                    const auto read = readFile(known.file);
                    QVERIFY2(read, qPrintable(read.error));
                    QVERIFY2(app::sheetOf(read.value->document) == expected,
                             qPrintable(QString::number(layer)));
                    QVERIFY(QFile::remove(known.file));
                }
    }
    void whatIsSavedIsNotWritten()
    {
        const EditedDocument edited(documentOf(sheetOf(1)));
        UnsavedWork work(edited);
        work.tell(document(false));
        QVERIFY(!work.write().unsaved);
        QVERIFY(!QFile::exists(document(false).file));
    }
    void theStyleInHandStaysOutOfTheDocument()
    {
        const EditedDocument edited(documentOf(sheetOf(3)));
        const std::size_t styles = edited.now().styles().size();
        UnsavedWork work(edited);
        Shape added = line(-5, 0);
        added.style.dashes = {1, 2};
        auto known = document(false);
        known.inHand = inHand(edited, added);
        work.tell(known);
        QVERIFY(work.write().unsaved);
        QCOMPARE(edited.now().styles().size(), styles);
        QCOMPARE(readFile(known.file).value->document.styles().size(), styles + 1);
        QVERIFY(QFile::remove(known.file));
    }
    // A signal leaves little time, and the drawing may be large.
    void aShapeInHandCostsNoCopyOfTheDrawing()
    {
        constexpr int lines = 5'000;
        const EditedDocument edited(documentOf(sheetOf(lines)));
        UnsavedWork work(edited);
        const auto taken = [&](std::optional<PendingObject> inHand) {
            auto known = document(true);
            known.inHand = std::move(inHand);
            work.tell(std::move(known));
            const std::size_t before = allocations;
            const auto written = work.write();
            return written.unsaved && !written.error ? allocations - before : 0;
        };
        taken({}); // what is made once
        const std::size_t without = taken({}), with = taken(inHand(edited, line(-5, 0)));
        QVERIFY(without > 0 && with > 0);
        QVERIFY2(with < without + lines / 10,
                 qPrintable(QStringLiteral("%1 and %2").arg(without).arg(with)));
    }
};

TEST_CLASS(UnsavedWorkTest, Core)
#include "tests/app/recovery/unsaved_work_test.moc"
