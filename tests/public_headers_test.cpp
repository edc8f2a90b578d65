// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include "tests/content_of.h"
#include "tests/test_class.h"

namespace public_headers_test {

// app/ and ui/ use the clipping library as any other program does: by the public headers that
// clipping/CMakeLists.txt lists.

namespace {

/// The public headers of the library and of its part with threads.
QStringList publicHeadersIn(const QString& cmake)
{
    static const QRegularExpression list(
        QStringLiteral("set\\(public_headers ([^)]*)\\)|FILES (parallel/\\w+\\.h)\\)"));
    QStringList headers;
    for (auto match = list.globalMatch(cmake); match.hasNext();) {
        const auto found = match.next();
        headers += (found.captured(1) + found.captured(2)).simplified().split(u' ');
    }
    return headers;
}

/// The other headers of the library that a file includes: one sentence each.
QStringList internalIn(const QStringList& publicHeaders, const QString& path, const QString& text)
{
    static const QRegularExpression include(QStringLiteral("^#include [\"<]clipping/([^\">]+)"),
                                            QRegularExpression::MultilineOption);
    QStringList found;
    for (auto match = include.globalMatch(text); match.hasNext();)
        if (const QString header = match.next().captured(1); !publicHeaders.contains(header))
            found << QStringLiteral("%1 includes clipping/%2, which is internal").arg(path, header);
    return found;
}

} // namespace

class PublicHeadersTest : public QObject {
    Q_OBJECT
    const QDir source_{QStringLiteral(SOURCE_DIR)};
    const QStringList headers_ =
        publicHeadersIn(contentOf(source_.filePath(QStringLiteral("clipping/CMakeLists.txt"))));

private slots:
    void theListedHeadersExist()
    {
        QVERIFY(headers_.contains(QStringLiteral("algorithm.h")));
        QVERIFY(headers_.contains(QStringLiteral("parallel/clip_all.h")));
        for (const QString& header : headers_)
            QVERIFY2(source_.exists(QStringLiteral("clipping/") + header), qPrintable(header));
    }

    void theReadmeDescribesThem()
    {
        const QString readme = contentOf(source_.filePath(QStringLiteral("clipping/README.md")));
        for (const QString& header : headers_) {
            const QRegularExpression row(QStringLiteral("^\\|[^|]*`%1`[^|]*\\| ").arg(header),
                                         QRegularExpression::MultilineOption);
            QVERIFY2(row.match(readme).hasMatch(), qPrintable(header));
        }
    }

    void theProgramIncludesNoOther()
    {
        QStringList found;
        int files = 0;
        for (const char* layer : {"app", "ui"})
            for (QDirIterator it(source_.filePath(QString::fromLatin1(layer)), {"*.h", "*.cpp"},
                                 QDir::Files, QDirIterator::Subdirectories);
                 it.hasNext(); ++files) {
                const QString path = it.next();
                found += internalIn(headers_, source_.relativeFilePath(path), contentOf(path));
            }
        QVERIFY(files > 700);
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

    void anInternalHeaderIsNamed()
    {
        const QStringList some{"algorithm.h", "parallel/clip_all.h"};
        QCOMPARE(publicHeadersIn(QStringLiteral("set(public_headers algorithm.h)\n"
                                                "  FILES parallel/clip_all.h)\n")),
                 some);
        QCOMPARE(internalIn(some, QStringLiteral("app/x.cpp"),
                            QStringLiteral("#include \"clipping/algorithm.h\"\n"
                                           "#include <clipping/parallel/clip_all.h>\n"
                                           "#include \"clipping/exact/turn.h\"\n")),
                 QStringList{"app/x.cpp includes clipping/exact/turn.h, which is internal"});
    }
};

} // namespace public_headers_test

TEST_CLASS(public_headers_test::PublicHeadersTest, Core)
#include "tests/public_headers_test.moc"
