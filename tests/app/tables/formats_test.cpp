// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/csv_text.h"
#include "app/tables/folded.h"
#include "app/tables/table.h"

#include <QBuffer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace tables_formats_test {

namespace {

/// All that could be taken for markup.
const QString hostile = QStringLiteral("[a\\b{c}_d^e~f%g&h$i#j|k*l`m<n>o[p],\"q\"");
/// The name of a drawing of somebody who likes to tease; the last letters are Greek and an omega.
const QString drawing = QStringLiteral(
    "*&amp;_%$#<b>\"|\n\n\r\t\\input{x}\x01 \u2212\u202f1 \u00d7 \u201cq\u201d \u03b1.svg");

std::vector<app::Table> teasing()
{
    return {{.names = {drawing, "n"},
             .rows = {{drawing, "1"}, {"[x] " + drawing, "2"}},
             .title = drawing,
             .key = "teasing",
             .facts = {{"scene", drawing}},
             .notes = {drawing}}};
}

std::vector<app::Table> twoTables()
{
    return {{.names = {"who", "ns", "share_%"},
             .rows = {{hostile, "1.50", ""}, {"cs", "-12", "7"}},
             .title = "Times & more_",
             .key = "times",
             .facts = {{"seed", "1"}, {"window", "-1,-2,3,4"}, {"flags", "-O3 50% _x"}},
             .notes = {"One 100 % sure <note>."}},
            {.names = {"x"}, .rows = {{"a b"}, {"2"}}}};
}

QString textAs(QStringView key, const std::vector<app::Table>& tables)
{
    for (const app::TableFormat& format : app::tableFormats())
        if (format.key == key)
            return format.text(tables);
    qFatal("no such format");
}

/// A table in which every row says which it is.
app::Table numbered(int rows, int columns)
{
    app::Table table{.names = {"which"}, .title = QString("%1 rows").arg(rows), .key = "long"};
    for (int c = 1; c < columns; ++c)
        table.names << QString("c%1").arg(c);
    for (int r = 0; r < rows; ++r) {
        QStringList row(QString("row-%1-of-%2").arg(r).arg(rows));
        while (row.size() < columns)
            row << "1234.56";
        table.rows.push_back(row);
    }
    return table;
}

QString latex()
{
    for (const char* name : {"pdflatex", "lualatex", "xelatex", "tectonic"})
        if (QString program = QStandardPaths::findExecutable(name); !program.isEmpty())
            return program;
    return {};
}

/// Writes tables.tex into the folder and makes tables.pdf of it, in as many passes as long tables
/// need to know their widths. What it says where that fails; else nothing.
QString compile(const QString& program, const QTemporaryDir& folder,
                const std::vector<app::Table>& tables)
{
    QFile file(folder.filePath("tables.tex"));
    if (!file.open(QIODevice::WriteOnly))
        return file.errorString();
    file.write(textAs(u"latex", tables).toUtf8());
    file.close();
    QStringList arguments{"tables.tex"};
    if (!program.endsWith("tectonic"))
        arguments.prepend("-interaction=nonstopmode");
    for (int pass = 0; pass < 3; ++pass) {
        QProcess process;
        process.setWorkingDirectory(folder.path());
        process.start(program, arguments);
        if (!process.waitForFinished(120'000) || process.exitCode() != 0)
            return process.errorString() + u'\n' + process.readAllStandardOutput();
    }
    return {};
}

} // namespace

class FormatsTest : public QObject {
    Q_OBJECT

private slots:
    void everyRowIsItsOwn()
    {
        QSet<QString> keys, endings;
        for (const app::TableFormat& format : app::tableFormats()) {
            keys << format.key;
            endings << format.ending;
            QVERIFY(!format.name.isEmpty());
            QVERIFY(format.text(twoTables()).endsWith('\n'));
        }
        QCOMPARE(std::size_t(keys.size()), app::tableFormats().size());
        QCOMPARE(endings.size(), keys.size());
        QCOMPARE(app::tableFormats()[0].key, "text");
    }

    void linesAreBrokenWhereTheyMayBe()
    {
        using Lines = QStringList;
        QCOMPARE(app::brokenLines("", 5), Lines{""});
        QCOMPARE(app::brokenLines("one two three", 7), (Lines{"one two", "three"}));
        QCOMPARE(app::brokenLines("one two three", 6), (Lines{"one", "two", "three"}));
        QCOMPARE(app::brokenLines("indivisible is long", 4), (Lines{"indivisible", "is", "long"}));
        QCOMPARE(app::brokenLines("1,488 of 131,711", 4), (Lines{"1,488", "of", "131,711"}));
        QCOMPARE(app::brokenLines("1.5,-20,3", 7, u","), (Lines{"1.5,", "-20,3"}));
        QCOMPARE(app::brokenLines("/usr/lib/a.so", 8, u"/"), (Lines{"/usr/", "lib/a.so"}));
        QCOMPARE(app::brokenLines("12345,", 3, u","), Lines{"12345,"});
    }

    // Wide numbers, names of several words, long texts, and texts that can be broken at commas.
    void aTableForPeopleFitsATerminal()
    {
        const QString words = "Every result is compared with exact arithmetic and nothing is lost ";
        const QString path = "/home/student/algorithms/build/release/with/a/long/name/mine.so";
        const QString ends = "0.12345678901234567,-1.2345678901234567e-300,3.1415926535897931,7";
        std::vector<app::Table> tables{
            numbered(3, 30),
            {.names = {"key", "year", "idea"},
             .rows = {{"cohen", "1967", words.repeated(5)}, {"skala", "2005", words}}},
            {.names = {"library", "rounded_outside", "most_ulps", "points"},
             .rows = {{path, "1234567", "2.375", "110"}}},
            {.names = {"category", "fault", "line", "window", "expected", "got"},
             .rows = {{"corners", "lost", ends, ends, ends, ends}}},
            {.names = {"n"},
             .rows = {{"1"}},
             .title = words.repeated(3),
             .facts = {{"x", words}},
             .notes = {words.repeated(2)}}};
        tables.front().title.clear();
        for (const app::Table& table : tables) {
            const QString text = textAs(u"text", {table});
            for (const QString& line : text.split('\n'))
                QVERIFY2(line.size() <= 80, qPrintable(line));
            for (qsizetype i = 0; i < table.names.size(); ++i) {
                QStringList parts = table.names[i].split('_');
                for (const QStringList& row : table.rows)
                    parts += row[i].split(QRegularExpression("[ ,/]"), Qt::SkipEmptyParts);
                for (const QString& part : parts)
                    QVERIFY2(text.contains(part), qPrintable(part + " in " + text));
            }
            const auto rows =
                text.count(QRegularExpression("^row-2-of-3 ", QRegularExpression::MultilineOption));
            QCOMPARE(rows, &table == &tables.front() ? 5 : 0); // blocks of six or seven columns
        }
    }

    void aRowIsALineWhateverItHolds()
    {
        const auto lines = [](const QString& text) { return text.trimmed().split('\n'); };
        const auto text = lines(textAs(u"text", teasing()));
        QCOMPARE(text.size(), 9); // title, names, rows, note, facts; three empty ones
        QVERIFY(text[4].startsWith("[x] *&amp;_%$#<b>\"|    \\input{x}"));
        const auto markdown = lines(textAs(u"markdown", teasing()));
        QCOMPARE(markdown.size(), 9);
        static const QRegularExpression markup("(?<!\\\\)[&*_$<>\\[\\]]"), bare("(?<!\\\\)\\|");
        for (const QString& line : markdown)
            QVERIFY2(!markup.match(line).hasMatch(), qPrintable(line));
        for (const int i : {2, 4, 5})
            QCOMPARE(markdown[i].count(bare), 3);
        QByteArray csv = textAs(u"csv", teasing()).toUtf8();
        QBuffer buffer(&csv);
        buffer.open(QIODevice::ReadOnly);
        app::csv::Records records(buffer);
        app::csv::Record record;
        QVERIFY(records.next(record) && records.next(record));
        using Fields = std::vector<std::string>;
        QCOMPARE(record.fields, (Fields{drawing.toStdString(), "1", drawing.toStdString()}));
        const auto json = QJsonDocument::fromJson(textAs(u"json", teasing()).toUtf8()).array();
        QCOMPARE(json[0]["rows"][0][drawing].toString(), drawing);
        QCOMPARE(json[0]["facts"]["scene"].toString(), drawing);
    }

    void latexTakesNoNameForItsOwn()
    {
        const QString text = textAs(u"latex", teasing());
        const auto rows = text.split('\n').filter(QRegularExpression(" \\\\\\\\$"));
        QCOMPARE(rows.size(), 3);
        for (const QString& row : rows) {
            QVERIFY(!row.startsWith('[') && !row.startsWith('*'));
            QVERIFY(
                row.contains("\\&amp;\\_\\%\\$\\#\\textless{}b\\textgreater{}\\textquotedbl{}"));
            QVERIFY(row.contains("\\textbackslash{}input\\{x\\}"));
            QVERIFY(row.contains("$-$~1 $\\times$ \u201cq\u201d U+03b1 .svg"));
        }
        for (const QChar c : text)
            QVERIFY(c == '\n' || c >= ' ');
    }

    void textStandsInColumns()
    {
        const app::Table table{.names = {"name", "ns"},
                               .rows = {{"a", "5.00"}, {"long", "12.00"}, {"c", ""}},
                               .facts = {{"seed", "1"}},
                               .notes = {"A note."}};
        QCOMPARE(textAs(u"text", {table}), "name     ns\n"
                                           "a      5.00\n"
                                           "long  12.00\n"
                                           "c\n"
                                           "\n"
                                           "A note.\n"
                                           "\n"
                                           "seed:       1\n");
        QCOMPARE(textAs(u"text", {table, table}).count("seed:"), 1);
        QCOMPARE(textAs(u"text", {table, table}).count("A note."), 2);
    }

    void csvReadsBack()
    {
        QByteArray bytes = textAs(u"csv", twoTables()).toUtf8();
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::ReadOnly);
        app::csv::Records text(buffer);
        app::csv::Record record;
        std::vector<std::vector<std::string>> records;
        while (text.next(record))
            records.push_back(record.fields);
        QCOMPARE(records.size(), 6u);
        using Fields = std::vector<std::string>;
        QCOMPARE(records[0], (Fields{"who", "ns", "share_%", "seed", "window", "flags"}));
        QCOMPARE(records[1],
                 (Fields{hostile.toStdString(), "1.50", "", "1", "-1,-2,3,4", "-O3 50% _x"}));
        QCOMPARE(records[3], Fields{"x"});
    }

    void jsonIsTyped()
    {
        const auto all = QJsonDocument::fromJson(textAs(u"json", twoTables()).toUtf8()).array();
        QCOMPARE(all.size(), 2);
        const QJsonObject table = all[0].toObject(), row = table["rows"][0].toObject();
        QCOMPARE(row["who"].toString(), hostile);
        QCOMPARE(row["ns"].toDouble(), 1.5);
        QVERIFY(row["share_%"].isNull());
        QCOMPARE(table["columns"].toArray().size(), 3);
        QCOMPARE(table["facts"]["seed"].toInt(), 1);
        QCOMPARE(table["table"].toString(), "times");
        QCOMPARE(table["notes"][0].toString(), "One 100 % sure <note>.");
        QVERIFY(all[1].toObject()["rows"][1]["x"].isString()); // not a column of numbers
        // No number is changed: 2^64 - 1 is none that a double holds.
        const app::Table big{.names = {"n"}, .rows = {{"18446744073709551615"}}};
        const auto text = textAs(u"json", {big});
        QVERIFY(text.contains("\"18446744073709551615\""));
    }

    void markdownHasPipesWhereColumnsAre()
    {
        const auto lines = textAs(u"markdown", twoTables()).split('\n');
        QCOMPARE(lines[0], "## Times \\& more\\_");
        static const QRegularExpression bare("(?<!\\\\)\\|");
        for (const int i : {2, 3, 4, 5})
            QCOMPARE(lines[i].count(bare), 4);
        QCOMPARE(lines[3], "|:---|---:|---:|");
        QVERIFY(lines.contains("- One 100 % sure \\<note\\>."));
        QVERIFY(lines.contains("- seed: 1"));
    }

    void latexIsWellFormed()
    {
        const QString text = textAs(u"latex", twoTables());
        QVERIFY(text.startsWith("\\documentclass"));
        QVERIFY(text.endsWith("\\end{document}\n"));
        QStringList open;
        static const QRegularExpression environments("\\\\(begin|end)\\{(\\w+)\\}");
        for (auto all = environments.globalMatch(text); all.hasNext();) {
            const auto one = all.next();
            if (one.captured(1) == "begin")
                open << one.captured(2);
            else
                QCOMPARE(open.isEmpty() ? QString() : open.takeLast(), one.captured(2));
        }
        QVERIFY(open.isEmpty());
        int braces = 0;
        for (qsizetype i = 0; i < text.size(); ++i) {
            const bool escaped = i > 0 && text[i - 1] == '\\';
            braces += escaped ? 0 : (text[i] == '{') - (text[i] == '}');
            QVERIFY(braces >= 0);
        }
        QCOMPARE(braces, 0);
        for (const char* rule : {"\\toprule", "\\midrule", "\\bottomrule"})
            QCOMPARE(text.count(rule), 2);
        // As many cells in each row as columns.
        const auto rows = text.split('\n').filter(QRegularExpression(" \\\\\\\\$"));
        QCOMPARE(rows.size(), 6);
        static const QRegularExpression ampersand("(?<!\\\\)&");
        for (int i = 0; i < 6; ++i)
            QCOMPARE(rows[i].count(ampersand), i < 3 ? 2 : 0);
        QVERIFY(text.contains("{@{}lrr@{}}") && text.contains("{@{}l@{}}"));
        QVERIFY(text.contains("Times \\& more\\_"));
    }

    void latexCompiles()
    {
        const QString program = latex();
        if (program.isEmpty())
            QSKIP("no LaTeX is installed: latexIsWellFormed looks at the structure instead");
        auto tables = twoTables();
        tables.push_back(teasing()[0]);
        QTemporaryDir folder;
        const QString error = compile(program, folder, tables);
        QVERIFY2(error.isEmpty(), qPrintable(error));
        QVERIFY(QFile::exists(folder.filePath("tables.pdf")));
    }

    void longTablesGoOnFromPageToPage()
    {
        QCOMPARE(textAs(u"latex", {numbered(30, 3)}).count("\\begin{longtable}"), 0);
        const std::vector tables{numbered(31, 3), numbered(200, 7), numbered(90, 12),
                                 numbered(60, 16)};
        const QString text = textAs(u"latex", tables);
        QCOMPARE(text.count("\\begin{longtable}"), 4);
        QCOMPARE(text.count("\\endhead"), 4);
        const QString program = latex(),
                      reader = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
        if (program.isEmpty() || reader.isEmpty())
            QSKIP("no LaTeX or no pdftotext is installed: the pages were not looked at");
        QTemporaryDir folder;
        const QString error = compile(program, folder, tables);
        QVERIFY2(error.isEmpty(), qPrintable(error));
        QFile log(folder.filePath("tables.log"));
        if (log.open(QIODevice::ReadOnly)) // tectonic keeps none
            QVERIFY2(!log.readAll().contains("Overfull"), "something juts out");
        QProcess process;
        process.start(reader, {"-layout", folder.filePath("tables.pdf"), "-"});
        QVERIFY(process.waitForFinished(60'000));
        const QString pages = QString::fromUtf8(process.readAllStandardOutput());
        QVERIFY(pages.count('\f') >= 8);
        for (const app::Table& table : tables)
            for (const QStringList& row : table.rows)
                QVERIFY2(pages.contains(row.front()), qPrintable(row.front()));
        for (const QString& page : pages.split('\f', Qt::SkipEmptyParts))
            QVERIFY2(page.contains("which"), qPrintable(page)); // headings
    }

    void factsAreTheLastColumnsOfCsv()
    {
        const app::Table table{
            .names = {"who", "rank"}, .rows = {{"cs", "1"}}, .facts = {{"seed", "7"}}};
        QCOMPARE(textAs(u"csv", {table}), "who,rank,seed\ncs,1,7\n");
    }
};

} // namespace tables_formats_test

TEST_CLASS(tables_formats_test::FormatsTest, Core)
#include "tests/app/tables/formats_test.moc"
