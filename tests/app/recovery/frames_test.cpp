// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/frames.h"

#include <QTest>

#include "tests/test_class.h"

namespace recovery_frames_test {

using namespace app;

namespace {

std::string framed(std::string payload, std::uint64_t number)
{
    std::string frame = std::string(frameHeader, '\0') + std::move(payload);
    sealFrame(frame, number);
    return frame;
}

} // namespace

class FramesTest : public QObject {
    Q_OBJECT

private slots:
    void areReadInOrder()
    {
        std::string bytes;
        for (std::size_t size = 0; size < 100; ++size)
            bytes += framed(std::string(size, 'a'), 5 + size);
        FrameReader frames(bytes, 5);
        for (std::size_t size = 0; size < 100; ++size) {
            const auto payload = frames.next();
            QVERIFY(payload && *payload == std::string(size, 'a'));
        }
        QVERIFY(!frames.next());
        QCOMPARE(frames.number(), std::uint64_t(105));
    }
    void areValidOnlyAtTheirPlace()
    {
        const std::string bytes = framed("some words", 7);
        QVERIFY(FrameReader(bytes, 7).next());
        QVERIFY(!FrameReader(bytes, 6).next());
        QVERIFY(!FrameReader(bytes, 8).next());
    }
    // Of every size around the words of 8 bytes and the groups of 4 words.
    void everyChangedBitIsNoticed()
    {
        for (std::size_t size = 0; size < 80; ++size) {
            const std::string bytes = framed(std::string(size, 'b'), 3);
            for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
                std::string changed = bytes;
                changed[bit / 8] = char(changed[bit / 8] ^ (1 << bit % 8));
                QVERIFY2(!FrameReader(changed, 3).next(), qPrintable(QString::number(bit)));
            }
            for (std::size_t cut = 0; cut < bytes.size(); ++cut)
                QVERIFY(!FrameReader(std::string_view(bytes).substr(0, cut), 3).next());
        }
    }
    void lentBytesAreAsCopiedOnes()
    {
        std::string all;
        for (int i = 0; i < 300; ++i)
            all += char(i * 7 + i / 50);
        for (std::size_t first = 0; first < 70; ++first)
            for (std::size_t count : {0, 1, 8, 31, 32, 33, 100, 130}) {
                const std::size_t second = first + 40, more = 37;
                Frame frame{
                    std::string(frameHeader, '\0') + all.substr(0, first)
                        + all.substr(first + count, 40) + all.substr(second + count + more),
                    {{frameHeader + first, std::string_view(all).substr(first, count)},
                     {frameHeader + second, std::string_view(all).substr(second + count, more)}}};
                sealFrame(frame, 9);
                std::string joined;
                for (const std::string_view part : frame.parts())
                    joined += part;
                QCOMPARE(joined.size(), frame.size());
                QVERIFY(joined == framed(all, 9));
            }
    }
    void aHugeSizeIsRefused()
    {
        const std::string bytes(frameHeader, '\xff');
        QVERIFY(!FrameReader(bytes, 0).next());
    }
};

} // namespace recovery_frames_test

TEST_CLASS(recovery_frames_test::FramesTest, None)
#include "tests/app/recovery/frames_test.moc"
