// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/csv_text.h"
#include "app/formats/csv/record_blocks.h"
#include "app/formats/csv/record_fields.h"

#include <QBuffer>
#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace formats_csv_record_blocks_test {

using namespace app::csv;

namespace {

using Rows = std::vector<std::pair<std::size_t, std::vector<std::string>>>; // line and fields

// What the reader of whole files finds, and where it refuses.
Rows whole(QIODevice& in)
{
    Records text(in);
    Rows rows;
    try {
        for (Record record; text.next(record);)
            rows.emplace_back(record.line, record.fields);
    } catch (const Refused& refused) {
        rows.emplace_back(refused.line, std::vector<std::string>{"refused"});
    }
    return rows;
}

Rows whole(const std::string& bytes)
{
    QByteArray copy = QByteArray::fromStdString(bytes);
    QBuffer buffer(&copy);
    buffer.open(QIODevice::ReadOnly);
    return whole(buffer);
}

// Gives one byte after the other, as a slow pipe does.
class Drops final : public QIODevice {
public:
    explicit Drops(const std::string& bytes) : bytes_(bytes)
    {
        open(QIODevice::ReadOnly | QIODevice::Unbuffered);
    }
    bool isSequential() const override { return true; }

private:
    qint64 readData(char* data, qint64 most) override
    {
        if (most == 0 || at_ == bytes_.size())
            return 0;
        *data = bytes_[at_++];
        return 1;
    }
    qint64 writeData(const char*, qint64) override { return -1; }

    std::string bytes_;
    std::size_t at_ = 0;
};

// Gives `piece` bytes at a time; `bytes` must outlive it.
ByteSource sourceOf(const std::string& bytes, std::size_t piece)
{
    return [&bytes, piece, at = std::size_t(0)](char* out, std::size_t size) mutable {
        const std::size_t count = std::min({piece, size, bytes.size() - at});
        bytes.copy(out, count, at);
        at += count;
        return count;
    };
}

// Why the blocks of this text are refused.
QString reasonInBlocks(const std::string& bytes)
{
    RecordBlocks blocks(sourceOf(bytes, 4096));
    try {
        for (RecordBlock block; blocks.next(block);)
            continue;
    } catch (const Refused& refused) {
        return refused.why;
    }
    return {};
}

// The same in blocks, from a source that gives `piece` bytes at a time.
Rows inBlocks(const std::string& bytes, std::size_t piece)
{
    RecordBlocks blocks(sourceOf(bytes, piece));
    Rows rows;
    RecordFields fields;
    RecordBlock block;
    try {
        for (bool more = blocks.first(block); more; more = blocks.next(block)) {
            if (block.record != rows.size())
                return {};
            for (const auto& place : block.places) {
                const auto found = fields.of(block.text(place), block.line + place.line);
                rows.emplace_back(block.line + place.line,
                                  std::vector<std::string>(found.begin(), found.end()));
            }
        }
    } catch (const Refused& refused) {
        rows.emplace_back(refused.line, std::vector<std::string>{"refused"});
    }
    return rows;
}

} // namespace

class RecordBlocksTest : public QObject {
    Q_OBJECT

private slots:
    void everyTextIsDividedAsInAWholeFile()
    {
        std::mt19937 random(7);
        const std::string alphabet = "\"\",,\n\r#a1 \n";
        for (int round = 0; round < 3000; ++round) {
            std::string text(random() % 40, ' ');
            for (char& c : text)
                c = alphabet[random() % alphabet.size()];
            if (round % 7 == 0)
                text.insert(0, "\xef\xbb\xbf");
            for (const std::size_t piece : {1, 2, 7, 1000})
                QVERIFY2(inBlocks(text, piece) == whole(text), text.c_str());
        }
    }

    void onlyTheFileBeginsWithAByteOrderMark()
    {
        const std::string mark = "\xef\xbb\xbf", row = mark + "1,1,2,2,\"a\"\n";
        QVERIFY(inBlocks("0,0,1,1\n" + row, 1000) == whole("0,0,1,1\n" + row));
        QVERIFY(inBlocks(mark + row, 1000) == whole(mark + row));
    }

    void aByteOrderMarkMayComeInParts()
    {
        const std::string text = "\xef\xbb\xbfx1,y1,x2,y2\n0,0,1,1\n";
        Drops drops(text);
        QVERIFY(whole(drops) == whole(text));
        QCOMPARE(whole(text).front().second.front(), std::string("x1"));
    }

    void aCommentMayBeLongerThanARecord()
    {
        const std::string comment = "#\"" + std::string(2'000'000, 'x');
        for (const char* end : {"\n1,2\n", "\r\n1,2", "\r1,2\n#", ""})
            QVERIFY(inBlocks("1,1\n" + comment + end, 4096) == whole("1,1\n" + comment + end));
    }

    void whatMakesARecordTooLongIsSaid()
    {
        const std::string rest(2 << 20, 'x');
        for (const bool quoted : {false, true}) {
            const std::string row = quoted ? "1,\"" : "1,a\"";
            QCOMPARE(reasonInBlocks("\"1\",1\n" + row + rest),
                     quoted ? "opens a quotation mark that is never closed."
                            : "is too long for CSV.");
        }
    }

    // Scanned anew for each piece, it takes many minutes.
    void aLongRecordMayComeInSmallPieces()
    {
        std::string quoted = "1,\"", plain = "1";
        while (quoted.size() < 5'000'000) {
            quoted += "two\n\"\"lines";
            plain += ",22";
        }
        for (const std::string& text : {quoted + "\"\n1,2\n", plain + "\n1,2\n"})
            QVERIFY(inBlocks(text, 7) == whole(text));
    }

    void aRecordThatNeverEndsIsRefused()
    {
        const std::string row = "1,2,3,4\n";
        for (const char c : {'1', '"'}) {
            const Rows rows =
                inBlocks(row + std::string(3 << 20, c == '"' ? 'x' : c).insert(0, 1, c), 1 << 16);
            QCOMPARE(rows.size(), 2u);
            QCOMPARE(rows[1].second.front(), "refused");
        }
    }
};

} // namespace formats_csv_record_blocks_test

TEST_CLASS(formats_csv_record_blocks_test::RecordBlocksTest, Core)
#include "tests/app/formats/csv/record_blocks_test.moc"
