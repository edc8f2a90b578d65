// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/path.h"

#include "app/document/path_storage.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace app {
namespace {

template <class T>
bool sameBits(std::span<const T> a, std::span<const T> b)
{
    return a.size() == b.size()
           && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

bool sameBits(const Point& a, const Point& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// The line or point that needs no heap block, if the subpaths are nothing else.
std::optional<clipping::Segment> lineOf(std::span<const Subpath> subpaths)
{
    if (subpaths.size() != 1 || subpaths[0].closed || subpaths[0].segments.size() > 1)
        return std::nullopt;
    const Subpath& only = subpaths[0];
    if (only.segments.empty())
        return clipping::Segment{only.start, only.start};
    const PathSegment& segment = only.segments[0];
    if (segment.curved || sameBits(only.start, segment.to)) // equal ends would read as a point
        return std::nullopt;
    return clipping::Segment{only.start, segment.to};
}

} // namespace

Path::Data* Path::lineMark()
{
    static Data mark;
    return &mark;
}

Path::Path(const clipping::Segment& line) : data_(lineMark()), ends_{line.a, line.b} {}

Path::Path(std::span<const Subpath> subpaths)
{
    if (subpaths.empty())
        return;
    if (const auto line = lineOf(subpaths)) {
        *this = Path(*line);
        return;
    }
    std::size_t segments = 0, curves = 0;
    for (const Subpath& subpath : subpaths) {
        segments += subpath.segments.size();
        curves += std::size_t(std::ranges::count_if(subpath.segments, &PathSegment::curved));
    }
    data_ =
        Data::of(subpaths.size() + segments + 2 * curves, subpaths.size(), curves ? segments : 0);
    ends_ = {Placement{}.scale, Placement{}.offset};

    Point* point = data_->firstPoint();
    std::uint32_t* size = data_->firstSize();
    std::uint8_t* kind = data_->firstKind();
    for (const Subpath& subpath : subpaths) {
        *size++ = std::uint32_t(subpath.segments.size() << 1 | std::size_t(subpath.closed));
        *point++ = subpath.start;
        for (const PathSegment& segment : subpath.segments) {
            if (curves)
                *kind++ = segment.curved;
            if (segment.curved) {
                *point++ = segment.control1;
                *point++ = segment.control2;
            }
            *point++ = segment.to;
        }
    }
}

Path::Path(const Path& other) noexcept : data_(other.data_), ends_(other.ends_)
{
    if (data_ && !isLine())
        data_->owners.fetch_add(1, std::memory_order_relaxed);
}

Path::Path(Path&& other) noexcept : data_(std::exchange(other.data_, nullptr)), ends_(other.ends_)
{
}

Path& Path::operator=(Path other) noexcept
{
    std::swap(data_, other.data_);
    std::swap(ends_, other.ends_);
    return *this;
}

Path::~Path()
{
    if (data_ && !isLine() && data_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) {
        data_->~Data();
        ::operator delete(data_);
    }
}

Placement Path::placement() const
{
    return data_ && !isLine() ? Placement{ends_[0], ends_[1]} : Placement{};
}

std::span<const Point> Path::stored() const
{
    return !data_ ? std::span<const Point>{} : isLine() ? ends_ : data_->points();
}

std::vector<Subpath> Path::subpaths() const
{
    if (!data_)
        return {};
    if (isLine())
        return {sameBits(ends_[0], ends_[1]) ? Subpath{ends_[0], {}, false}
                                             : Subpath{ends_[0], {{ends_[1]}}, false}};
    std::vector<Subpath> subpaths(data_->subpathCount);
    Data::Reader reader(*data_, placement());
    for (Subpath& subpath : subpaths)
        reader.next(subpath);
    return subpaths;
}

std::optional<clipping::Segment> Path::singleLine() const
{
    return isLine() ? std::optional(clipping::Segment{ends_[0], ends_[1]}) : std::nullopt;
}

std::size_t Path::subpathCount() const { return !data_ ? 0 : isLine() ? 1 : data_->subpathCount; }

std::size_t Path::pointCount() const { return stored().size(); }

bool Path::straight() const { return !data_ || data_->kindCount == 0; }

bool Path::hasArea() const
{
    return data_ && !isLine()
           && (!straight() || std::ranges::any_of(data_->sizes(), [](std::uint32_t size) {
                  return size >> 1 > 1;
              }));
}

HeapPart Path::heapPart() const
{
    if (!data_ || isLine())
        return {};
    return {data_, heapBlock(data_->bytes()), data_->owners.load(std::memory_order_acquire) != 1};
}

Path Path::placed(const Placement& where) const
{
    if (isLine())
        return Path(clipping::Segment{where(ends_[0]), where(ends_[1])});
    Path path = *this;
    if (data_) {
        const Placement both = placement().then(where);
        path.ends_ = {both.scale, both.offset};
    }
    return path;
}

bool operator==(const Path& a, const Path& b)
{
    if (!a.data_ || !b.data_ || a.isLine() || b.isLine())
        return a.data_ == b.data_ && (!a.data_ || sameBits<Point>(a.ends_, b.ends_));
    const Path::Data &x = *a.data_, &y = *b.data_;
    const Placement here = a.placement(), there = b.placement();
    const bool samePlacement = sameBits<Point>(a.ends_, b.ends_);
    if (&x == &y && samePlacement)
        return true;
    if (!sameBits(x.sizes(), y.sizes()) || !sameBits(x.kinds(), y.kinds()))
        return false;
    return std::ranges::equal(x.points(), y.points(), [&](const Point& p, const Point& q) {
        return sameBits(here(p), there(q));
    });
}

Subpath reversedPath(const Subpath& path)
{
    if (path.segments.empty())
        return path;
    Subpath back{path.segments.back().to, {}, path.closed};
    for (std::size_t i = path.segments.size(); i-- > 0;) {
        const auto& [to, control1, control2, curved] = path.segments[i];
        back.segments.push_back(
            {i > 0 ? path.segments[i - 1].to : path.start, control2, control1, curved});
    }
    return back;
}

} // namespace app
