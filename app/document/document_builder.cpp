// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"

namespace app {

void DocumentBuilder::add(const Object& object)
{
    objects_.append(object);
    containers_.addObjects();
}

void DocumentBuilder::add(const ObjectRow& row)
{
    objects_.append(row);
    containers_.addObjects();
}

void DocumentBuilder::addLine(const clipping::Segment& line, const StyleEntry& style)
{
    objects_.appendLine(line, style);
    containers_.addObjects();
}

void DocumentBuilder::add(const Objects& objects)
{
    objects_.append(objects);
    containers_.addObjects(objects.size());
}

Document DocumentBuilder::take(const Page& page, About about, ClipWindows windows)
{
    return Document(DocumentParts{page, std::move(about), std::move(objects_), containers_.take(),
                                  std::move(windows)});
}

} // namespace app
