// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <atomic>

namespace opencv_test { namespace {

// Memory that runs out at any allocation leaves the object usable and the input as it was.

typedef std::function<void(SuperpixelGWatershed&)> Action;

//! Passes on to the standard allocator, or has no memory.
class FailingAllocator CV_FINAL : public MatAllocator
{
public:
    FailingAllocator() : left_until_failure(-1) {}
    UMatData* allocate(int dims, const int* sizes, int type, void* data, size_t* step, AccessFlag flags,
                       UMatUsageFlags usage) const CV_OVERRIDE
    {
        if (left_until_failure >= 0 && left_until_failure-- == 0)
            throw cv::Exception(Error::StsNoMem, "no memory for a matrix", CV_Func, __FILE__, __LINE__);
        return Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
    }
    bool allocate(UMatData* data, AccessFlag access, UMatUsageFlags usage) const CV_OVERRIDE
    {
        return Mat::getStdAllocator()->allocate(data, access, usage);
    }
    void deallocate(UMatData* data) const CV_OVERRIDE { Mat::getStdAllocator()->deallocate(data); }

    mutable std::atomic<int> left_until_failure; // below 0: none fails
};

//! Stays until the end, because a Mat remembers where it was allocated.
FailingAllocator& failingAllocator()
{
    static FailingAllocator allocator;
    return allocator;
}

enum MemoryKind { BY_NEW, BY_MAT };

//! Lets one allocation fail while it lives: the one after `count` others.
class Fault
{
public:
    Fault(int kind, int count) : kind_(kind), allocator_(&failingAllocator())
    {
        if (kind == BY_NEW)
            failNewAfter(count);
        else
            failingAllocator().left_until_failure = count;
    }
    ~Fault()
    {
        failNewAfter(-1);
        failingAllocator().left_until_failure = -1;
    }
    bool happened() const { return kind_ == BY_NEW ? newHasFailed() : failingAllocator().left_until_failure < 0; }

private:
    const int kind_;
    const AllocatorGuard allocator_;
};

//! What is segmented, and how.
struct Stream
{
    explicit Stream(int algorithm_) : algorithm(algorithm_), rng(theRNG())
    {
        for (int i = 0; i < 2; i++)
        {
            images[i] = makeScene(Size(72, 54), rng);
            depths[i] = makeDepth(images[i].size(), 0.2, rng);
            images[i].convertTo(images[i], CV_32F, 1. / 255);
        }
        mask = makeMask(DISCS, images[0].size(), rng);
        other_mask = makeMask(FRAME_MASK, mask.size(), rng);
        markers = makeMarkers(mask.size(), 30, rng);
        before = copies();
    }

    ~Stream()
    {
        const std::vector<Mat> after = copies();
        for (size_t i = 0; i < after.size(); i++)
            EXPECT_EQ(0, cvtest::norm(before[i], after[i], NORM_INF)) << "input " << i << " was written to";
    }

    std::vector<Mat> copies() const
    {
        const Mat all[] = { images[0], images[1], depths[0], depths[1], mask, other_mask, markers };
        std::vector<Mat> clones;
        for (int i = 0; i < 7; i++)
            clones.push_back(all[i].clone());
        return clones;
    }

    Ptr<SuperpixelGWatershed> makeObject(const Action& set) const
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1, 1, 3, 60, algorithm);
        set(*gws);
        return gws;
    }

    void iterate(SuperpixelGWatershed& gws, int frame = 0) const { gws.iterate(images[frame], depths[frame], 3); }

    Mat labelsOfFresh(const Action& set, int frame = 0) const
    {
        Ptr<SuperpixelGWatershed> gws = makeObject(set);
        iterate(*gws, frame);
        return labelsOf(gws);
    }

    int algorithm;
    RNG& rng;
    Mat images[2], depths[2], mask, other_mask, markers;
    std::vector<Mat> before;
};

//! Lets each allocation of an action fail in turn, in a new object each time, and checks this object after it. A Mat of
//! OpenCV 5 asks for memory twice, so there an action can end well where one allocation failed.
void failEverywhere(int kind, const std::function<Ptr<SuperpixelGWatershed>()>& make, const Action& act,
                    const std::function<void(const Ptr<SuperpixelGWatershed>&, bool failed)>& check)
{
    bool happened = true;
    for (int count = 0; happened && !testing::Test::HasFailure(); count++)
    {
        SCOPED_TRACE(format("%s, after %d others", kind == BY_NEW ? "new" : "Mat", count));
        const Ptr<SuperpixelGWatershed> gws = make();
        int code = Error::StsOk;
        {
            Fault fault(kind, count);
            try { act(*gws); }
            catch (const cv::Exception& e) { code = e.code; }
            happened = fault.happened();
        }
        const bool failed = code != Error::StsOk;
        EXPECT_TRUE(!failed || (happened && code == Error::StsNoMem)) << code;
        EXPECT_TRUE(failed || !happened || CV_VERSION_MAJOR >= 5);
        check(gws, failed);
    }
}

void nothing(SuperpixelGWatershed&) {}

typedef testing::TestWithParam<tuple<int, int> > ximgproc_GWatershed_faults;

TEST_P(ximgproc_GWatershed_faults, next_image_is_segmented_as_by_a_fresh_object)
{
    ThreadsGuard one(1);
    const Stream stream(get<0>(GetParam()));
    const Action settings[] = {
        nothing,
        [&](SuperpixelGWatershed& gws) { gws.setMask(stream.mask); },
        [&](SuperpixelGWatershed& gws) { gws.setMarkers(stream.markers); },
        [&](SuperpixelGWatershed& gws) { gws.setMarkers(stream.markers); gws.setMask(stream.mask); },
        [&](SuperpixelGWatershed& gws) { gws.setTemporal(true); },
        [&](SuperpixelGWatershed& gws) { gws.setTemporal(true); gws.setMask(stream.mask); }
    };
    for (int i = 0; i < 6; i++)
        for (int frames_before = 0; frames_before < 2; frames_before++)
        {
            SCOPED_TRACE(format("settings %d, %d frames before", i, frames_before));
            const Mat expected = stream.labelsOfFresh(settings[i], 1);
            failEverywhere(get<1>(GetParam()),
                [&]()
                {
                    Ptr<SuperpixelGWatershed> gws = stream.makeObject(settings[i]);
                    if (frames_before)
                        stream.iterate(*gws, 0);
                    return gws;
                },
                [&](SuperpixelGWatershed& gws) { stream.iterate(gws, 1); },
                [&](const Ptr<SuperpixelGWatershed>& gws, bool failed)
                {
                    if (!failed)
                        return;
                    EXPECT_TRUE(gws->empty());
                    EXPECT_EQ(0, gws->getNumberOfSuperpixels());
                    stream.iterate(*gws, 1);
                    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
                });
        }
}

TEST_P(ximgproc_GWatershed_faults, merging_can_be_repeated)
{
    ThreadsGuard one(1);
    const Stream stream(get<0>(GetParam()));
    const Action merges[] = {
        [](SuperpixelGWatershed& gws) { gws.mergeSimilar(20); },
        [](SuperpixelGWatershed& gws) { gws.enforceLabelConnectivity(90); },
        [](SuperpixelGWatershed& gws) { gws.mergeSimilar(40); gws.mergeSimilar(10); }
    };
    for (int i = 0; i < 3; i++)
        for (int masked = 0; masked < 2; masked++)
        {
            const Action set = [&](SuperpixelGWatershed& gws) { gws.setMask(masked ? stream.mask : Mat()); };
            const auto make = [&]()
            {
                Ptr<SuperpixelGWatershed> gws = stream.makeObject(set);
                stream.iterate(*gws);
                return gws;
            };
            const Ptr<SuperpixelGWatershed> whole = make();
            merges[i](*whole);
            const Mat merged = labelsOf(whole), next = stream.labelsOfFresh(set, 1);
            failEverywhere(get<1>(GetParam()), make, merges[i],
                [&](const Ptr<SuperpixelGWatershed>& gws, bool failed)
                {
                    if (failed)
                        merges[i](*gws);
                    EXPECT_TRUE(equalMats(merged, labelsOf(gws)));
                    stream.iterate(*gws, 1);
                    EXPECT_TRUE(equalMats(next, labelsOf(gws)));
                });
        }
}

TEST_P(ximgproc_GWatershed_faults, a_mask_or_markers_are_set_or_not)
{
    ThreadsGuard one(1);
    const Stream stream(get<0>(GetParam()));
    const Action with_mask = [&](SuperpixelGWatershed& gws) { gws.setMask(stream.mask); };
    const Action actions[] = {
        [&](SuperpixelGWatershed& gws) { gws.setMask(stream.other_mask); },
        [&](SuperpixelGWatershed& gws) { gws.setMask(noArray()); },
        [&](SuperpixelGWatershed& gws) { gws.setMarkers(stream.markers); }
    };
    for (int i = 0; i < 3; i++)
    {
        SCOPED_TRACE(i);
        const Action with_both = [&](SuperpixelGWatershed& gws) { with_mask(gws); actions[i](gws); };
        const Mat before = stream.labelsOfFresh(with_mask), after = stream.labelsOfFresh(with_both);
        failEverywhere(get<1>(GetParam()), [&]() { return stream.makeObject(with_mask); }, actions[i],
            [&](const Ptr<SuperpixelGWatershed>& gws, bool failed)
            {
                stream.iterate(*gws);
                EXPECT_TRUE(equalMats(failed ? before : after, labelsOf(gws)));
                actions[i](*gws);
                stream.iterate(*gws);
                EXPECT_TRUE(equalMats(after, labelsOf(gws)));
            });
    }
}

enum { NUM_ANSWERS = 12 };

//! All that can be asked of a segmentation.
void askAll(const SuperpixelGWatershed& gws, const Stream& stream, Mat* out)
{
    gws.getLabels(out[0]);
    gws.getLabelContourMask(out[1]);
    gws.getWatershedLineMask(out[2]);
    gws.getStatistics(stream.images[0], stream.depths[0], out[3], out[4], out[5], out[6], out[7], out[8]);
    gws.getAdjacency(stream.images[0], stream.depths[0], out[9], out[10], out[11]);
}

TEST_P(ximgproc_GWatershed_faults, questions_change_nothing)
{
    ThreadsGuard one(1);
    const Stream stream(get<0>(GetParam()));
    for (int masked = 0; masked < 2; masked++)
    {
        const Ptr<SuperpixelGWatershed> gws =
                stream.makeObject([&](SuperpixelGWatershed& g) { g.setMask(masked ? stream.mask : Mat()); });
        stream.iterate(*gws);
        Mat expected[NUM_ANSWERS];
        askAll(*gws, stream, expected);
        failEverywhere(get<1>(GetParam()), [&]() { return gws; },
            [&](SuperpixelGWatershed& g)
            {
                Mat answers[NUM_ANSWERS];
                askAll(g, stream, answers);
            },
            [&](const Ptr<SuperpixelGWatershed>&, bool)
            {
                Mat answers[NUM_ANSWERS];
                askAll(*gws, stream, answers);
                for (int i = 0; i < NUM_ANSWERS; i++)
                    EXPECT_EQ(0, cvtest::norm(expected[i], answers[i], NORM_INF)) << i;
            });
    }
}

TEST_P(ximgproc_GWatershed_faults, objects_are_cleared_and_read_or_stay_as_they_are)
{
    ThreadsGuard one(1);
    const Stream stream(get<0>(GetParam()));
    const Mat expected = stream.labelsOfFresh(nothing);
    FileStorage out("", FileStorage::WRITE | FileStorage::MEMORY | FileStorage::FORMAT_YAML);
    stream.makeObject(nothing)->write(out);
    const FileStorage in(out.releaseAndGetString(), FileStorage::READ | FileStorage::MEMORY);
    const FileNode parameters = in.root();
    const Action actions[] = {
        [](SuperpixelGWatershed& gws) { gws.clear(); },
        [&](SuperpixelGWatershed& gws) { gws.read(parameters); }
    };
    for (int i = 0; i < 2; i++)
        failEverywhere(get<1>(GetParam()),
            [&]()
            {
                Ptr<SuperpixelGWatershed> gws = stream.makeObject(nothing);
                stream.iterate(*gws);
                return gws;
            },
            actions[i],
            [&](const Ptr<SuperpixelGWatershed>& gws, bool failed)
            {
                EXPECT_EQ(i == 0 && !failed, gws->empty());
                stream.iterate(*gws);
                EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
            });
}

TEST_P(ximgproc_GWatershed_faults, factories_throw_or_make_an_object)
{
    ThreadsGuard one(1);
    const Stream stream(get<0>(GetParam()));
    const Mat expected = segment(stream.images[0], stream.depths[0], stream.algorithm, 10);
    failEverywhere(get<1>(GetParam()), [&]() { return stream.makeObject(nothing); },
        [&](SuperpixelGWatershed&)
        {
            createSuperpixelGWatershed(72, 54, 3, 60, stream.algorithm);
            createSuperpixelGWatershed(stream.images[0], stream.depths[0], stream.algorithm, 10);
        },
        [&](const Ptr<SuperpixelGWatershed>&, bool)
        {
            EXPECT_TRUE(equalMats(expected, segment(stream.images[0], stream.depths[0], stream.algorithm, 10)));
        });
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_faults,
                        testing::Combine(testing::ValuesIn(ALGORITHMS), testing::Values(int(BY_NEW), int(BY_MAT))));

// Which allocation is the one after some others differs from run to run. Matrices only: the pool of threads of OpenCV
// keeps its lock for ever if a new of its own fails.
TEST(ximgproc_SuperpixelGWatershed, is_usable_after_a_fault_in_another_thread)
{
    ThreadsGuard three(3);
    for (int i = 0; i < 2; i++)
    {
        const Stream stream(ALGORITHMS[i]);
        const Mat expected = stream.labelsOfFresh(nothing);
        failEverywhere(BY_MAT, [&]() { return stream.makeObject(nothing); },
            [&](SuperpixelGWatershed& gws) { stream.iterate(gws); },
            [&](const Ptr<SuperpixelGWatershed>& gws, bool)
            {
                stream.iterate(*gws);
                EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
            });
    }
}

}} // namespace
