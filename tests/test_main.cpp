// SPDX-License-Identifier: GPL-3.0-or-later
// A program of tests: the first argument names the class to run, as ctest does (app.cut.cut_test); the others are
// QtTest's. Without a name each class runs in a process of its own.
#include "tests/test_class.h"

#ifdef QT_WIDGETS_LIB
#include <QApplication>
using WidgetsApplication = QApplication;
#else
#include <QGuiApplication>
using WidgetsApplication = QGuiApplication; // no test here asks for widgets
#endif
#include <QProcess>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace {

std::vector<tests::TestClass>& classes()
{
    static std::vector<tests::TestClass> all;
    return all;
}

// tests/app/cut/cut_test.cpp: app.cut.cut_test
QString nameOf(const tests::TestClass& test)
{
    QString name = QString::fromUtf8(test.file).mid(int(sizeof SOURCE_DIR "/tests/") - 1);
    name.chop(int(sizeof ".cpp") - 1);
    name.replace(u'/', u'.');
    return name.startsWith("ui.tasks.") ? name.mid(3) : name;
}

std::unique_ptr<QCoreApplication> started(tests::Application kind, int& count, char** arguments)
{
    if (kind == tests::Application::None)
        return nullptr;
    if (kind == tests::Application::Core)
        return std::make_unique<QCoreApplication>(count, arguments);
    if (kind == tests::Application::Gui)
        return std::make_unique<QGuiApplication>(count, arguments);
    return std::make_unique<WidgetsApplication>(count, arguments);
}

int runAll(const QString& program)
{
    int failed = 0;
    for (const tests::TestClass& test : classes())
        failed += QProcess::execute(program, {nameOf(test)}) != 0;
    std::printf("%zu classes, %d failed\n", classes().size(), failed);
    return failed > 0;
}

} // namespace

bool tests::add(const TestClass& test)
{
    classes().push_back(test);
    return true;
}

int main(int count, char** arguments)
{
    std::ranges::sort(classes(), {}, nameOf);
    if (count < 2)
        return runAll(QString::fromLocal8Bit(arguments[0]));
    const auto test = std::ranges::find(classes(), QString::fromLocal8Bit(arguments[1]), nameOf);
    if (test == classes().end()) {
        std::fputs("There is no such class here, but:\n", stderr);
        for (const tests::TestClass& each : classes())
            std::fprintf(stderr, "%s\n", qPrintable(nameOf(each)));
        return 2;
    }
    arguments[1] = arguments[0];
    int left = count - 1;
    if (test->application != tests::Application::None)
        QCoreApplication::setAttribute(Qt::AA_Use96Dpi); // as QTEST_MAIN does
    const auto application = started(test->application, left, arguments + 1);
    return test->run(left, arguments + 1);
}
