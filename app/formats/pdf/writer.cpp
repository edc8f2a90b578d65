// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/pdf/writer.h"

#include "app/base/number.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/formats/painted.h"
#include "app/formats/pdf/content.h"
#include "app/formats/pdf/images.h"
#include "app/formats/rounded.h"
#include "app/formats/seen_part.h"

#include <algorithm>

namespace app::pdf {
namespace {

constexpr double pointsPerMillimetre = 72 / 25.4;
constexpr double largestPage = 14'400; // units; on larger pages the unit is larger

std::string shortestNumber(double number)
{
    std::string result;
    appendNumber(result, number);
    return result;
}

/// Writes the objects of a PDF file, numbered from 1 in the order in which they are added.
class ObjectWriter {
public:
    explicit ObjectWriter(QIODevice& out) : out_(out) { put("%PDF-1.6\n%\xe2\xe3\xcf\xd3\n"); }

    void add(const std::string& body)
    {
        offsets_.push_back(written_);
        put(std::to_string(offsets_.size()) + " 0 obj\n" + body + "\nendobj\n");
    }

    void addStream(const QByteArray& bytes)
    {
        constexpr int sizeOfQtHeader = 4; // the rest is a zlib stream, as PDF requires
        add(Stream{"/Filter/FlateDecode", qCompress(bytes).sliced(sizeOfQtHeader)});
    }

    void add(const Stream& stream)
    {
        add("<<" + stream.entries + "/Length " + std::to_string(stream.bytes.size())
            + ">>\nstream\n" + stream.bytes.toStdString() + "\nendstream");
    }

    void finish(const std::string& trailer)
    {
        const qint64 table = written_;
        const std::string size = std::to_string(offsets_.size() + 1);
        std::string text = "xref\n0 " + size + "\n0000000000 65535 f \n";
        for (const qint64 offset : offsets_) {
            const std::string digits = std::to_string(offset);
            text += std::string(10 - std::min<std::size_t>(10, digits.size()), '0') + digits
                    + " 00000 n \n";
        }
        put(text + "trailer\n<</Size " + size + trailer + ">>\nstartxref\n" + std::to_string(table)
            + "\n%%EOF\n");
    }

    bool failed() const { return failed_; }

private:
    void put(const std::string& text)
    {
        failed_ = failed_ || !writeAll(out_, text);
        written_ += qint64(text.size());
    }

    QIODevice& out_;
    std::vector<qint64> offsets_;
    qint64 written_ = 0;
    bool failed_ = false;
};

std::string reference(std::size_t object) { return std::to_string(object) + " 0 R"; }

std::string pageObject(const Point& size, double userUnit, std::size_t contents,
                       const std::string& resources)
{
    std::string page = "<</Type/Page/Parent 2 0 R/MediaBox[0 0 " + shortestNumber(size.x) + ' '
                       + shortestNumber(size.y) + "]/Contents " + reference(contents)
                       + "/Resources<<" + resources + ">>/Group<</S/Transparency/CS/DeviceRGB>>";
    if (userUnit > 1)
        page += "/UserUnit " + shortestNumber(userUnit);
    return page + ">>";
}

// Acrobat shows pages up to 15,000,000 inches; on less than a micrometre nothing can be seen.
constexpr double mostMillimetres = 15e6 * 25.4, leastMillimetres = 1e-3;

std::optional<QString> faultOfPage(const Page& page)
{
    if (auto fault = faultOf(page))
        return fault;
    const Point size = paperOf(page).millimetres;
    if (std::max(size.x, size.y) <= mostMillimetres && std::min(size.x, size.y) >= leastMillimetres)
        return std::nullopt;
    return Text::tr("the page is too large or too small for PDF: its sides can have 0.001 mm to "
                    "381 km. Change the width and height of the page.");
}

/// The whole page as a filled area.
Object pageOf(const Paper& paper, const Colour& colour)
{
    const Point size = paper.millimetres / paper.millimetresPerUnit;
    const Point from = paper.corner, to = from + size;
    const Subpath around{from, {{{to.x, from.y}}, {to}, {{from.x, to.y}}}, true};
    return {.path = Path({&around, 1}), .style = {.stroke = std::nullopt, .fill = colour}};
}

// Adds a page as the object `number`, and its content as the next one.
void addPage(ObjectWriter& objects, std::size_t number, const Document& document,
             const WriteOptions& options, Images& images)
{
    const Paper paper = paperOf(document.page());
    const Point points = paper.millimetres * pointsPerMillimetre;
    const double userUnit = std::max(1.0, std::max(points.x, points.y) / largestPage);
    const Point size = points / userUnit;
    const double scale = paper.millimetresPerUnit * pointsPerMillimetre / userUnit;

    Content content(options);
    content.place(scale, {-paper.corner.x * scale, size.y + paper.corner.y * scale});
    if (const auto colour = options.backgroundOf(document.page()); colour && colour->alpha > 0)
        content.paint(pageOf(paper, *colour));
    visitSeen(
        document, [&](const Object& object) { content.paint(object); },
        [&](const Underlay& underlay) { content.paint(underlay, images.numberOf(underlay.file)); });
    objects.add(pageObject(size, userUnit, number + 1, content.resources()));
    objects.addStream(content.bytes());
}

// Two objects for each image.
void addImages(ObjectWriter& objects, const Images& images)
{
    Images numbered = images;
    for (const auto& file : images.files()) {
        const auto streams = streamsOf(file, numbered.numberOf(file) + 1);
        objects.add(streams.front());
        if (streams.size() > 1)
            objects.add(streams[1]);
        else
            objects.add("null");
    }
}

} // namespace

std::optional<QString> writePages(std::size_t count, const PageMaker& page, QIODevice& out,
                                  const WriteOptions& options)
{
    constexpr std::size_t first = 3, objectsOfPage = 2;
    std::string kids;
    for (std::size_t i = 0; i < count; ++i)
        kids += reference(first + objectsOfPage * i) + ' ';
    ObjectWriter objects(out);
    const std::size_t info = first + objectsOfPage * count;
    Images images(info + 1);
    objects.add("<</Type/Catalog/Pages 2 0 R>>");
    objects.add("<</Type/Pages/Kids[" + kids + "]/Count " + std::to_string(count) + ">>");
    for (std::size_t i = 0; i < count && !objects.failed(); ++i) {
        const Document document = rounded(page(i), options).document;
        if (auto fault = faultOfPage(document.page()))
            return fault;
        addPage(objects, first + objectsOfPage * i, document, options, images);
    }
    objects.add("<</Producer(Clearcut " CLEARCUT_VERSION ")>>");
    addImages(objects, images);
    objects.finish("/Root 1 0 R/Info " + reference(info));
    return objects.failed() ? std::optional(out.errorString() + u'.') : std::nullopt;
}

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    return writePages(
        1, [&](std::size_t) { return document; }, out, options);
}

} // namespace app::pdf
