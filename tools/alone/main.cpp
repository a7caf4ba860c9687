// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// The main program of the tests in a build beside an installed OpenCV, in place of test/test_main.cpp.

#include "opencv2/ts.hpp"

namespace
{

//! Each test begins as with ts: the same random numbers, and as many threads as there are processors.
class Beginning : public testing::EmptyTestEventListener
{
    void OnTestStart(const testing::TestInfo&) override
    {
        cv::theRNG().state = 0x12345678;
        cv::setNumThreads(-1);
    }
};

//! Exceptions that a test expects are not to be printed.
int printNothing(int, const char*, const char*, const char*, int, void*)
{
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new Beginning);
    cv::redirectError(printNothing);
    return RUN_ALL_TESTS();
}
