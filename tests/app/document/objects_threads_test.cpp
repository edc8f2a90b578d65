// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/objects.h"

#include <QTest>

#include <thread>

#include "tests/app/document/random_objects.h"
#include "tests/test_class.h"

namespace document_objects_threads_test {

using namespace app;

class ObjectsThreadsTest : public QObject {
    Q_OBJECT

private slots:
    void readersOfACopyWhileItIsEdited()
    {
        RandomObjects random(5);
        const std::vector<Object> all = random.some(100);
        Objects objects = objectsOf(all);
        std::vector<std::jthread> readers;
        for (int i = 0; i < 4; ++i)
            readers.emplace_back([snapshot = objects, &all] {
                for (int round = 0; round < 20; ++round)
                    if (!equal(Objects(snapshot), all))
                        qFatal("the snapshot has changed");
            });
        for (int i = 0; i < 200; ++i) {
            const Objects added = objectsOf(random.some(3));
            objects.splice(std::size_t(random.whole(0, 90)), std::size_t(random.whole(0, 4)),
                           added);
            objects.append(all[std::size_t(i % 100)]);
        }
    }
};

} // namespace document_objects_threads_test

TEST_CLASS(document_objects_threads_test::ObjectsThreadsTest, None)
#include "tests/app/document/objects_threads_test.moc"
