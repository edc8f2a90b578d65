// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

// A test file has a namespace of its own, named by its path below app/, ui/ or clipping/, and registers its class
// below it, in one line:
//
//     TEST_CLASS(cut_cut_test::CutTest, None)
//     #include "tests/app/cut/cut_test.moc"

namespace tests {

/// Which application runs beside the test.
enum class Application { None, Core, Gui, Widgets };

struct TestClass {
    const char* file;
    Application application;
    int (*run)(int count, char** arguments);
};

/// Adds a class to those that test_main.cpp can run.
bool add(const TestClass& test);

template <class Test>
int run(int count, char** arguments)
{
    Test test;
    return QTest::qExec(&test, count, arguments);
}

} // namespace tests

#define TEST_CLASS_NAMED(name, Class, application)                                                 \
    [[maybe_unused]] static const bool name =                                                      \
        tests::add({__FILE__, tests::Application::application, tests::run<Class>});
#define TEST_CLASS_NUMBERED(number, ...) TEST_CLASS_NAMED(registered_##number, __VA_ARGS__)
#define TEST_CLASS_AS(number, ...) TEST_CLASS_NUMBERED(number, __VA_ARGS__)
#define TEST_CLASS(Class, application) TEST_CLASS_AS(__COUNTER__, Class, application)
