// SPDX-License-Identifier: MIT
#include "clipping/parallel/clip_all.h"

#include "clipping/batch/kernels.h"
#include "clipping/gradual_underflow.h"
#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"

#include <algorithm>
#include <cstring>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace clipping {
namespace {

/// A filter of the pipeline works. It sees what filters have written that ended before it began:
/// oneTBB sees to that, but is not compiled with ThreadSanitizer, which has to be told.
class InFilter {
public:
    explicit InFilter([[maybe_unused]] const void* pipeline)
#ifdef __SANITIZE_THREAD__
        : pipeline_(const_cast<void*>(pipeline))
    {
        __tsan_acquire(pipeline_);
    }
    ~InFilter() { __tsan_release(pipeline_); }

private:
    void* pipeline_;
#else
    {
    }
#endif
};

/// A part of the segments, which is clipped into a slot and then moved to its place in the output.
template <class T>
struct Slice {
    std::size_t begin, end;
    BasicClipped<BasicSegment<T>>* slot;
    std::size_t pieces;
};

/// The division of the work. The slots are at the end of the output, behind everything that the
/// parts can fill: the segments whose pieces could reach the slots are clipped last. There are few
/// slots, so they stay in the caches, and a slot is reused only after its part has been moved.
struct Plan {
    std::size_t slots, partSize, shared;
};
Plan planFor(std::size_t count)
{
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t slots = 2 * threads;
    const std::size_t partSize = std::clamp<std::size_t>(count / (32 * slots), 1024, 32768);
    const bool worthwhile =
        threads > 1 && count >= parallelThreshold && 2 * slots * partSize < count;
    return {slots, partSize, worthwhile ? count - slots * partSize : 0};
}

template <class T>
std::size_t inParallel(std::span<const BasicSegment<T>> in, const BasicWindow<T>& window,
                       std::span<BasicClipped<BasicSegment<T>>> out)
{
    const GradualUnderflow here;
    requireRoom(in.size(), out.size());
    const Plan plan = planFor(in.size());
    std::size_t begun = 0, pieces = 0;
    const auto take = [&](tbb::flow_control& flow) -> Slice<T> {
        const InFilter seen(&plan);
        if (begun == plan.shared) {
            flow.stop();
            return {};
        }
        const std::size_t begin = begun;
        begun = std::min(begin + plan.partSize, plan.shared);
        const std::size_t slot = begin / plan.partSize % plan.slots;
        return {begin, begun, out.data() + plan.shared + slot * plan.partSize, 0};
    };
    const auto clip = [&](Slice<T> slice) {
        const InFilter seen(&plan);
        const GradualUnderflow onThisThread;
        slice.pieces =
            clipBatch(Batch<T>{in.data(), slice.begin, slice.end, window, slice.slot}).pieces;
        return slice;
    };
    const auto place = [&](const Slice<T>& slice) {
        const InFilter seen(&plan);
        std::memcpy(static_cast<void*>(out.data() + pieces), slice.slot,
                    slice.pieces * sizeof *slice.slot);
        pieces += slice.pieces;
    };
    { // what is here is there when the filters begin
        const InFilter made(&plan);
    }
    if (plan.shared > 0)
        tbb::parallel_pipeline(
            plan.slots,
            tbb::make_filter<void, Slice<T>>(tbb::filter_mode::serial_in_order, take)
                & tbb::make_filter<Slice<T>, Slice<T>>(tbb::filter_mode::parallel, clip)
                & tbb::make_filter<Slice<T>, void>(tbb::filter_mode::serial_in_order, place));
    const InFilter seen(&plan);
    const Batch<T> rest{in.data(), plan.shared, in.size(), window, out.data() + pieces};
    return pieces + clipBatch(rest).pieces;
}

} // namespace

std::size_t clipAllInParallel(std::span<const Segment> in, const Window& window,
                              std::span<Clipped> out)
{
    return inParallel(in, window, out);
}

std::size_t clipAllInParallel(std::span<const BasicSegment<float>> in,
                              const BasicWindow<float>& window,
                              std::span<BasicClipped<BasicSegment<float>>> out)
{
    return inParallel(in, window, out);
}

} // namespace clipping
