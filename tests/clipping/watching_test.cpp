// SPDX-License-Identifier: GPL-3.0-or-later
// Counting and tracing cost nothing when unused: the machine code of the fast path neither counts
// nor records nor allocates, and is no longer than what the compiler makes where the calls of the
// watcher are taken out of the source (the library `unwatched`).
#include <QHash>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <utility>

#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace watching_test {

namespace {

/// A function in an archive's machine code.
struct Function {
    QStringList code;   ///< instructions and what they refer to, without addresses
    QSet<QString> uses; ///< the symbols that it refers to
};
using Functions = QHash<QString, Function>;

/// `.text.unlikely+0x1c` is given by its section alone: a function without a name.
QString withoutOffset(QString symbol)
{
    return symbol.remove(QRegularExpression("[+-]0x[0-9a-f]+$"));
}

Functions functionsIn(const QString& archive)
{
    QProcess objdump;
    objdump.start("objdump", {"-dr", "--no-show-raw-insn", archive});
    objdump.waitForFinished();
    static const QRegularExpression begins("^[0-9a-f]+ <(.+)>:$");
    static const QRegularExpression refersTo("^\\s+[0-9a-f]+: (R_\\w+)\\s+(\\S+)$");
    static const QRegularExpression instruction("^\\s+[0-9a-f]+:\\t(.*)$");
    static const QRegularExpression inside("[0-9a-f]+ <(\\S+)>");
    static const QRegularExpression unlinked("(?<=^call )\\S+$|(?<=^jmp )\\S+$");
    Functions functions;
    Function* now = nullptr;
    QString target; // of the last instruction, unless what the linker is told follows
    const auto settle = [&] {
        if (now && !target.isEmpty())
            now->uses += withoutOffset(std::exchange(target, {}));
    };
    for (const QString& line : QString::fromUtf8(objdump.readAllStandardOutput()).split('\n')) {
        if (const auto name = begins.match(line); name.hasMatch()) {
            settle();
            now = &functions[name.captured(1)];
        } else if (const auto use = refersTo.match(line); use.hasMatch() && now) {
            target.clear();
            const QString symbol = withoutOffset(use.captured(2));
            // Until it is linked it leads to the next instruction, even one of another function.
            now->code.last().remove(unlinked);
            now->code += use.captured(1) + ' ' + (symbol.startsWith('.') ? "." : symbol);
            now->uses += symbol;
        } else if (const auto words = instruction.match(line); words.hasMatch() && now) {
            settle();
            target = inside.match(words.captured(1)).captured(1);
            now->code += words.captured(1).simplified().replace(inside, "\\1");
        }
    }
    settle();
    return functions;
}

/// Every clipping function of the library: clipOne, clipMany, clipBatch, clipAll …, but not
/// the templates that also count and trace.
QStringList fastPath(const Functions& functions)
{
    static const QRegularExpression clips("([5-9]|[1-9]\\d)clip[A-Z]|10outsideAll|5Exact4many");
    static const QRegularExpression watches("clipCounted|7CountedI|Recorder");
    QStringList names;
    for (auto f = functions.keyBegin(); f != functions.keyEnd(); ++f)
        if (f->contains(clips) && !f->contains(watches))
            names += *f;
    names.sort();
    return names;
}

/// What a function refers to, and what that refers to, and so on.
QSet<QString> reach(const Functions& functions, const QString& name)
{
    QSet<QString> seen;
    QStringList open{name};
    while (!open.isEmpty()) {
        const QString next = open.takeLast();
        if (seen.contains(next))
            continue;
        seen += next;
        if (const auto found = functions.find(next); found != functions.end())
            open += QStringList(found->uses.begin(), found->uses.end());
    }
    return seen;
}

} // namespace

class WatchingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (QStandardPaths::findExecutable("objdump").isEmpty())
            QSKIP("There is no objdump (binutils) to look at the machine code with");
        if (QLatin1String(BUILD) != QLatin1String("optimised"))
            QSKIP("The machine code of this build is instrumented or not optimised");
        library_ = functionsIn(CLIPPING_ARCHIVE);
        QVERIFY(fastPath(library_).size() > 16);
    }

    void nothingIsCountedOrRecorded()
    {
        static const QRegularExpression traces(
            "8clipping10operationsE|__tls_get_addr|7CountedI|Recorder");
        static const QRegularExpression prepares(
            "InPolygon|PolylineRuns|PreparedRegion|LineSweep"); // seldom
        static const QRegularExpression allocates("_Zn[wa]m|^malloc$");
        int reached = 0;
        for (const QString& name : notEmpty(fastPath(library_))) {
            const QSet<QString> all = reach(library_, name);
            QStringList found = QStringList(all.begin(), all.end()).filter(traces);
            if (!name.contains(prepares))
                found += QStringList(all.begin(), all.end()).filter(allocates);
            QVERIFY2(found.isEmpty(), qPrintable(name + " reaches " + found.join(", ")));
            reached += int(all.size());
        }
        qInfo(
            "%lld functions of the fast path refer to %d symbols; none of them counts or records, "
            "and none allocates but for polygons, polylines and regions",
            qlonglong(fastPath(library_).size()), reached);
    }

    /// The other two uses are found to count and trace.
    void countingAndTracingAreSeen()
    {
        int counting = 0, recording = 0;
        for (auto f = library_.begin(); f != library_.end(); ++f) {
            const QSet<QString> all = reach(library_, f.key());
            counting += f.key().contains("9countMany") && all.contains("_ZN8clipping10operationsE");
            recording += f.key().contains("8traceOne") && all.contains("_Znwm");
        }
        QVERIFY(counting > 8);
        QVERIFY(recording > 8);
    }

    /// Instruction for instruction, or nearly: a text without calls may lead the compiler to lay
    /// out the same work in another way. clipMany holds its whole algorithm, whatever its length.
    void theFastCodeIsTheSameWithoutTheCalls()
    {
        const Functions unwatched = functionsIn(UNWATCHED_ARCHIVE);
        int loops = 0, same = 0;
        double most = 0;
        for (const QString& name : fastPath(unwatched).filter("8clipMany")) {
            const QStringList with = library_.value(name).code, without = unwatched[name].code;
            ++loops;
            same += with == without;
            most = std::max(most, double(with.size()) / double(without.size()));
            QVERIFY2(with.size() <= 1.05 * without.size(),
                     qPrintable(QString("%1 has %2 instructions, %3 without the calls")
                                    .arg(name)
                                    .arg(with.size())
                                    .arg(without.size())));
        }
        QVERIFY(loops >= 14 && 2 * same >= loops);
        qInfo("%d of %d loops are the same instructions with and without the calls of the watcher; "
              "no loop is longer than %.3f of the one without",
              same, loops, most);
    }

private:
    Functions library_;
};

} // namespace watching_test

TEST_CLASS(watching_test::WatchingTest, Core)
#include "tests/clipping/watching_test.moc"
