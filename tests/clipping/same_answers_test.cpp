// SPDX-License-Identifier: GPL-3.0-or-later
// The library as it is and the library as it was before its algorithms were written anew
// (tests/clipping/before, compiled under another namespace) give the same bytes.
// CLEARCUT_SEGMENTS=10000000 asks about as many random segments a question.
#include <QTest>

#include <algorithm>
#include <array>

#include "tests/clipping/answers.h"
#include "tests/clipping/blocks.h"

namespace before {
std::vector<Question> questions();
Answers answers(const Question& question, const Block& block);
} // namespace before

namespace {

/// Questions whose answers are counted in another way than before, and why.
constexpr std::array<std::string_view, 4> countedAnew{
    "cohen-sutherland box", // it moves an end on the two other axes only, as in the plane
    // In space they ask what they ask in the plane: whether u1 (tL) is less than 1, and u0 (tE)
    // greater than 0. That is two comparisons more for what is visible.
    "liang-barsky box",
    "cyrus-beck box",
    "midpoint-subdivision box", // the differences to the sides are taken only where a code is not 0
};
constexpr std::size_t bytesOfCounts = 5 * sizeof(std::uint64_t); // at the end of the answers

/// Whether old and new give the same answers, except for the counts where they are made anew.
bool agree(const Question& question, const Block& block)
{
    Answers old = before::answers(question, block), now = clipping::answers(question, block);
    if (std::ranges::count(countedAnew, question.name) != 0)
        for (Answers* answers : {&old, &now})
            answers->resize(answers->size() - bytesOfCounts);
    return old == now;
}

/// Numbers of a window or of a segment, which read back as they are.
QString text(const double* begin, std::size_t count)
{
    QStringList words;
    for (std::size_t i = 0; i < count; ++i)
        words += QString::number(begin[i], 'g', 17);
    return words.join(", ");
}

/// The first segment that alone gets another answer.
QString firstDifference(const Question& question, const Block& block)
{
    const std::size_t n = question.numbers == Numbers::Space ? 6 : 4;
    for (std::size_t i = 0; i < block.segments.size(); i += n) {
        const Block one{block.name,
                        block.window,
                        {block.segments.begin() + long(i), block.segments.begin() + long(i + n)}};
        if (!agree(question, one))
            return QString("%1, %2, window %3, segment %4")
                .arg(question.name.c_str(), block.name.c_str(),
                     text(block.window.data(), block.window.size()), text(&block.segments[i], n));
    }
    return QString("%1, %2: together only").arg(question.name.c_str(), block.name.c_str());
}

} // namespace

class SameAnswersTest : public QObject {
    Q_OBJECT

private slots:
    void theSameQuestions()
    {
        const auto old = before::questions(), now = clipping::questions();
        QVERIFY(old.size() > 48);
        for (const Question& question : old)
            QVERIFY2(std::ranges::any_of(now,
                                         [&](const Question& q) {
                                             return q.name == question.name
                                                    && q.numbers == question.numbers;
                                         }),
                     question.name.c_str());
    }

    void sameBytes_data()
    {
        QTest::addColumn<QString>("name");
        for (const Question& question : before::questions())
            QTest::newRow(question.name.c_str()) << QString::fromStdString(question.name);
    }
    void sameBytes()
    {
        QFETCH(QString, name);
        const auto all = before::questions();
        const Question question = *std::ranges::find(all, name.toStdString(), &Question::name);
        for (const Block& block : hardBlocks(question.numbers, 2000))
            compare(question, block);
        const std::size_t wanted = qEnvironmentVariable("CLEARCUT_SEGMENTS", "20000").toULongLong();
        for (unsigned seed = 0; asked_ < wanted; ++seed, asked_ += inABlock)
            compare(question, randomBlock(question.numbers, inABlock, seed));
        asked_ = 0;
    }

private:
    static constexpr std::size_t inABlock = 10'000;
    std::size_t asked_ = 0;

    static void compare(const Question& question, const Block& block)
    {
        if (!agree(question, block))
            QFAIL(qPrintable(firstDifference(question, block)));
    }
};

QTEST_GUILESS_MAIN(SameAnswersTest)
#include "same_answers_test.moc"
