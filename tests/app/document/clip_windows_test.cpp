// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/clip_windows.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace document_clip_windows_test {

using namespace app;

namespace {

ClipWindows randomWindows(std::mt19937& random)
{
    ClipWindows windows{{}, Keep(random() % 2)};
    for (auto left = random() % 7; left > 0; --left)
        windows.list.push_back({.name = QString::number(random()),
                                .operation = WindowOperation(random() % 4),
                                .visible = random() % 4 > 0});
    return windows;
}

/// What the windows keep of a place that is in those windows whose bits are set: as defined.
bool keeps(const ClipWindows& windows, unsigned in)
{
    const auto first = std::ranges::find_if(windows.list, &ClipWindow::visible);
    if (first == windows.list.end())
        return true;
    bool kept = first->operation == WindowOperation::CutOut
                || first->operation == WindowOperation::Intersect;
    for (std::size_t i = 0; i < windows.list.size(); ++i) {
        const bool here = in >> i & 1;
        if (!windows.list[i].visible)
            continue;
        switch (windows.list[i].operation) {
        case WindowOperation::Add:
            kept = kept || here;
            break;
        case WindowOperation::CutOut:
            kept = kept && !here;
            break;
        case WindowOperation::Intersect:
            kept = kept && here;
            break;
        case WindowOperation::Replace:
            kept = here;
        }
    }
    return kept == (windows.keep == Keep::Inside);
}

} // namespace

class ClipWindowsTest : public QObject {
    Q_OBJECT

private slots:
    void thoseInEffectKeepTheSame()
    {
        std::mt19937 random(1);
        int replaced = 0;
        for (int round = 0; round < 2'000; ++round) {
            const ClipWindows all = randomWindows(random);
            const auto numbers = numbersInEffect(all);
            const ClipWindows some = inEffect(all);
            QCOMPARE(some.list.size(), numbers.size());
            QVERIFY(std::ranges::none_of(some.list, [](const ClipWindow& window) {
                return !window.visible || window.operation == WindowOperation::Replace;
            }));
            for (unsigned in = 0; in < 1u << all.list.size(); ++in) {
                unsigned inSome = 0;
                for (std::size_t i = 0; i < numbers.size(); ++i)
                    inSome |= (in >> numbers[i] & 1) << i;
                QCOMPARE(keeps(some, inSome), keeps(all, in));
            }
            for (std::size_t i = 0; i < all.list.size(); ++i) {
                const auto by = replacing(all, i);
                QCOMPARE(by.has_value(),
                         all.list[i].visible && std::ranges::count(numbers, i) == 0);
                replaced += by.has_value();
                if (by)
                    QVERIFY(*by > i && all.list[*by].operation == WindowOperation::Replace);
            }
        }
        QVERIFY(replaced > 1'000);
    }
};

} // namespace document_clip_windows_test

TEST_CLASS(document_clip_windows_test::ClipWindowsTest, None)
#include "tests/app/document/clip_windows_test.moc"
