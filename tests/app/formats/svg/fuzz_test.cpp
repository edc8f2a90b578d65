// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of damaged files: each is either read, and then comes back as it is, or refused in a
// sentence.
#include <QDir>
#include <QTest>

#include <random>

#include "tests/app/formats/svg/text.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace formats_svg_fuzz_test {

namespace {

constexpr int casesPerFile = 3000;
constexpr std::size_t longest = 12'000; // larger files would only be slower

class Damage {
public:
    explicit Damage(unsigned seed) : random_(seed) {}

    QByteArray of(QByteArray text)
    {
        for (auto n = 1 + below(3); n > 0 && !text.isEmpty(); --n)
            once(text);
        return text;
    }

private:
    qsizetype below(qsizetype n) { return qsizetype(random_() % std::size_t(n)); }

    void once(QByteArray& text)
    {
        static const QByteArrayList tokens{
            "1e400",   "-1e308", "NaN",  "0",       "-",       "1e-320",    "%",     "em",
            "<",       ">",      "/>",   "'",       "\"",      "&amp;",     "&x;",   "url(#",
            "inherit", "Z",      "A",    "c",       "matrix(", "999999999", "\xff",  "{",
            "}",       "var(--", "/*",   "p:q",     "&nbsp;",  "fill-box",  "unset", ";",
            ":",       "--w:",   "mask", "circle(", "url(#c)"};
        const auto at = below(text.size());
        switch (below(6)) {
        case 0:
            text[at] = char(below(256));
            break;
        case 1:
            text[at] = char(text[at] ^ (1 << below(8)));
            break;
        case 2:
            text.truncate(at);
            break;
        case 3:
            text.remove(at, 1 + below(40));
            break;
        case 4:
            text.insert(at, tokens[below(tokens.size())]);
            break;
        default:
            text.insert(at, text.mid(below(text.size()), below(200)));
            break;
        }
    }

    std::mt19937_64 random_;
};

} // namespace

class FuzzTest : public QObject {
    Q_OBJECT

private slots:
    void damagedFiles_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* place : {"/tests/app/formats/data", "/tests/app/formats/data/css"}) {
            const QDir folder(QString(SOURCE_DIR) + place);
            for (const QString& name : notEmpty(folder.entryList({"*.svg"})))
                QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }
    void damagedFiles()
    {
        QFETCH(QString, path);
        const QByteArray whole = contentOf(path).left(longest);
        Damage damage(1);
        int read = 0;
        for (int i = 0; i < casesPerFile; ++i) {
            const QByteArray text = damage.of(whole);
            const auto first = readText(text);
            if (!first) {
                QVERIFY2(first.error.endsWith('.') && !first.error.contains('\n'),
                         first.error.toUtf8() + " <- " + text);
                continue;
            }
            ++read;
            const QByteArray copy = textOf(first.value->document);
            const auto second = readText(copy);
            QVERIFY2(second, text);
            QVERIFY2(second.value->document == first.value->document, text);
        }
        QVERIFY(read > casesPerFile / 20 && read < casesPerFile); // both happen
    }
};

} // namespace formats_svg_fuzz_test

TEST_CLASS(formats_svg_fuzz_test::FuzzTest, None)
#include "tests/app/formats/svg/fuzz_test.moc"
