// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/name_object.h"

#include "app/base/text.h"
#include "app/commands/name_object.h"
#include "app/session/units.h"

namespace app {
namespace {

constexpr qsizetype longestName = 1000; // characters; typed by hand

QString idOf(const QString& typed)
{
    QString id = typed.simplified().left(longestName);
    id.removeIf([](QChar c) { return !c.isPrint(); });
    return id.replace(u' ', u'_');
}

bool isTaken(const Objects& objects, std::size_t object, const QString& id)
{
    bool taken = false;
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& view) {
        taken = taken || (i != object && view.particulars().id == id);
    });
    return taken;
}

} // namespace

bool nameObject(Session& session, std::size_t object, const QString& typed)
{
    const Objects& objects = session.now().objects();
    const QString id = idOf(typed);
    if (object >= objects.size() || objects[object].particulars().id == id)
        return false;
    const Containers& containers = session.now().containers();
    if (containers.locked(containers.containerOf(object))) {
        emit session.refused(Text::tr("%1 is in a locked layer or group. Unlock that first.")
                                 .arg(objectText(session, object)));
        return false;
    }
    if (!id.isEmpty() && isTaken(objects, object, id)) {
        emit session.refused(Text::tr("Another object is called %1. Choose another name.").arg(id));
        return false;
    }
    session.history.push(new NameObject(session.document, object, id));
    return true;
}

} // namespace app
