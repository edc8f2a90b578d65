// SPDX-License-Identifier: GPL-3.0-or-later
// The library's results do not change, bit for bit: each row, form and use is called
// with every hard block, and its results have the fingerprint that fingerprints.txt keeps.
// CLEARCUT_FINGERPRINTS=FILE writes the current fingerprints into a file.
#include "clipping/algorithm.h"

#include <QFile>
#include <QMap>
#include <QTest>

#include <algorithm>

#include "tests/clipping/fingerprint.h"
#include "tests/test_class.h"

namespace fingerprints_test {

namespace {

QMap<QString, QString> kept()
{
    QMap<QString, QString> all;
    QFile file(SOURCE_DIR "/tests/clipping/fingerprints.txt");
    if (file.open(QIODevice::ReadOnly))
        for (const QString& line :
             QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts))
            all[line.section(": ", 0, 0)] = line.section(": ", 1);
    return all;
}

} // namespace

class FingerprintsTest : public QObject {
    Q_OBJECT

private slots:
    void resultsHaveNotChanged_data()
    {
        QTest::addColumn<QString>("name");
        for (const Question& question : clipping::questions())
            QTest::newRow(question.name.c_str()) << QString::fromStdString(question.name);
    }
    void resultsHaveNotChanged()
    {
        QFETCH(QString, name);
        for (const Question& question : clipping::questions())
            if (question.name == name.toStdString())
                found_[name] = QString::fromStdString(fingerprint(question));
        if (isNew(name))
            QSKIP("This row is new. CLEARCUT_FINGERPRINTS=FILE keeps its answers from now on");
        QVERIFY2(was_.contains(name), qPrintable(name + " has no fingerprint"));
        QCOMPARE(found_[name], was_[name]);
    }

    /// Only instructions that this processor lacks may be missing.
    void everyFingerprintIsTested()
    {
        QVERIFY(was_.size() >= 56);
        for (const QString& name : was_.keys())
            if (!found_.contains(name)) {
                QVERIFY2(name.startsWith("kernel "), qPrintable(name));
                qInfo("%s: not on this processor", qPrintable(name));
            }
    }

    void cleanupTestCase()
    {
        QFile file(qEnvironmentVariable("CLEARCUT_FINGERPRINTS"));
        if (!file.fileName().isEmpty() && file.open(QIODevice::WriteOnly))
            for (auto line = found_.cbegin(); line != found_.cend(); ++line)
                file.write((line.key() + ": " + line.value() + '\n').toUtf8());
    }

private:
    /// Whether the question is about a row ("KEY corrected") that has no fingerprint at all.
    bool isNew(const QString& name) const
    {
        const QString key = name.section(' ', 0, 0);
        return clipping::findAlgorithm(key.toStdString())
               && std::ranges::none_of(was_.keys(), [&](const QString& kept) {
                      return kept.section(' ', 0, 0) == key;
                  });
    }

    const QMap<QString, QString> was_ = kept();
    QMap<QString, QString> found_;
};

} // namespace fingerprints_test

TEST_CLASS(fingerprints_test::FingerprintsTest, Core)
#include "tests/clipping/fingerprints_test.moc"
