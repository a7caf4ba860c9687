// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// What a person expects of superpixels where there is little to follow, or too much: RGWATERSHED on patterns, even
// areas, ramps, and thin lines.

const int REGION_SIZES[] = { 13, 14, 17, 20, 21, 30 };
const int MERGED = 10; // times as many superpixels, which are merged

Mat superpixels(const Mat& image, int region_size, float ruler = 10, int times = 1)
{
    const int n = cvRound(double(image.total()) / (region_size * region_size));
    Ptr<SuperpixelGWatershed> gws =
            createSuperpixelGWatershed(image.cols, image.rows, image.channels(), n * times, RGWATERSHED, ruler);
    gws->iterate(image);
    gws->mergeSimilar(n);
    return labelsOf(gws);
}

//! Superpixels of a region size, merged to a tenth of them.
Mat mergedToATenth(const Mat& image, int region_size)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_size);
    gws->iterate(image);
    gws->mergeSimilar(gws->getNumberOfSuperpixels() / MERGED);
    return labelsOf(gws);
}

void addNoise(Mat& image, double level)
{
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols * image.channels(); x++)
        {
            uchar& value = image.ptr(y)[x];
            value = saturate_cast<uchar>(value + cvRound(theRNG().gaussian(level)));
        }
}

enum PatternKind { BOARD, UPRIGHT_STRIPES, LEVEL_STRIPES, SLANTED_STRIPES, BOARD_IN_PERSPECTIVE, PATTERN_KINDS };

Mat makePattern(PatternKind kind, int side, bool colored)
{
    const Vec3b colors[2][2] = { { Vec3b(60, 60, 60), Vec3b(200, 200, 200) },
                                 { Vec3b(40, 60, 190), Vec3b(170, 200, 60) } };
    Mat image(240, 320, CV_8UC3);
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
        {
            const double farther = kind == BOARD_IN_PERSPECTIVE ? 3 - 2. * y / image.rows : 1;
            const int column = cvFloor((x - 160) * farther / side);
            const int row = cvFloor((kind == BOARD_IN_PERSPECTIVE ? 400 * farther : y) / side);
            const int square = kind == UPRIGHT_STRIPES ? column
                             : kind == LEVEL_STRIPES ? row : kind == SLANTED_STRIPES ? (x + y) / side : column + row;
            image.at<Vec3b>(y, x) = colors[colored][square & 1];
        }
    return image;
}

//! As it is, with noise, blurred, with noise and then blurred.
void spoil(Mat& image, int way)
{
    if (way & 1)
        addNoise(image, 8);
    if (way & 2)
        GaussianBlur(image, image, Size(), 0.8);
}

//! Calls visit(image, region_size, number, what) for one of `every` patterns.
template <typename Visit> void visitPatterns(int every, const Visit& visit)
{
    int number = 0;
    for (int region_size : REGION_SIZES)
        for (int kind = 0; kind < PATTERN_KINDS; kind++)
            for (int side = 1; side <= 2 * region_size; side += side < 6 ? 1 : side < 20 ? 3 : 7)
                for (int way = 0; way < 4; way++)
                {
                    if (number++ % every != 0)
                        continue;
                    Mat image = makePattern(PatternKind(kind), side, number % 2 != 0);
                    spoil(image, way);
                    visit(image, region_size, number, format("%d, side %d, %d, %d", kind, side, region_size, way));
                }
}

// A superpixel with both colours of a pattern is nearer to all of it than the squares are to each other.
TEST(ximgproc_SuperpixelGWatershed, no_superpixel_runs_away_with_a_pattern)
{
    visitPatterns(5, [](const Mat& image, int region_size, int, const String& what)
    {
        for (int merged = 0; merged < 2; merged++)
            EXPECT_LE(extremeAreas(superpixels(image, region_size, 10, merged ? MERGED : 1))[1], 4) << what;
    });
}

// Any number from all to a tenth is as good. Unions that are parts of larger ones later must wait for their number.
TEST(ximgproc_SuperpixelGWatershed, no_superpixel_runs_away_with_a_pattern_at_any_number)
{
    visitPatterns(9, [](const Mat& image, int region_size, int number, const String& what)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_size);
        gws->setEffort(number % 4);
        gws->iterate(image);
        const int all = gws->getNumberOfSuperpixels();
        for (int n = all * 7 / 8; n >= all / 10; n = n * 7 / 8)
        {
            gws->mergeSimilar(n);
            EXPECT_LE(extremeAreas(labelsOf(gws))[1], 4) << what << ", " << n << " of " << all;
        }
    });
}

// Random rows beside random columns of grey levels: the means of both are the same, and all contrasts, too.
TEST(ximgproc_SuperpixelGWatershed, textures_of_different_directions_stay_apart)
{
    const Size size(320, 240);
    const int border = 150, cases = 20;
    double mixed = 0; // pixels on the side of the border on which less of their superpixel lies
    for (int i = 0; i < cases; i++)
    {
        Mat rows(size.height, 1, CV_8UC1), columns(1, size.width, CV_8UC1), image;
        theRNG().state = i + 1;
        randu(rows, 108, 149);
        randu(columns, 108, 149);
        repeat(columns, size.height, 1, image);
        repeat(rows, 1, border, image.colRange(0, border));
        const std::vector<std::vector<Point> > found = pixelsOf(superpixels(image, 20));
        for (const std::vector<Point>& pixels : found)
        {
            const int left = int(std::count_if(pixels.begin(), pixels.end(), [](Point p) { return p.x < border; }));
            mixed += std::min(left, int(pixels.size()) - left);
        }
    }
    EXPECT_LE(mixed / cases, 900); // of 14 superpixels of 400 pixels that the border would cut into halves
}

// Each stripe has a row of whole blocks. What is merged of them grows broader when boundaries are settled.
TEST(ximgproc_SuperpixelGWatershed, stripes_of_two_blocks_have_no_superpixel_over_the_image)
{
    for (int region_size : REGION_SIZES)
        for (int kind = UPRIGHT_STRIPES; kind <= LEVEL_STRIPES; kind++)
            for (int side = 8; side <= 10; side++)
            {
                const Mat labels = superpixels(makePattern(PatternKind(kind), side, true), region_size);
                EXPECT_LE(extremeAreas(labels)[1], 4) << kind << ", side " << side << ", " << region_size;
            }
}

// There superpixels are swept twice when they have their pixels, and grow each time.
TEST(ximgproc_SuperpixelGWatershed, blurred_stripes_of_three_small_blocks_have_no_superpixel_over_the_image)
{
    for (int kind = UPRIGHT_STRIPES; kind <= LEVEL_STRIPES; kind++)
        for (int cut = 0; cut < 60; cut += 2)
        {
            Mat image = makePattern(PatternKind(kind), 9, true)(Range(cut / 2, 240), Range(cut, 320)).clone();
            GaussianBlur(image, image, Size(), 0.8);
            EXPECT_LE(extremeAreas(superpixels(image, 13))[1], 4) << kind << ", " << cut;
        }
}

TEST(ximgproc_SuperpixelGWatershed, cells_of_a_grid_on_an_even_image)
{
    const Size sizes[] = { Size(320, 240), Size(640, 480), Size(481, 321), Size(240, 320) };
    for (const Size& size : sizes)
        for (int region_size : REGION_SIZES)
        {
            const Mat labels = superpixels(Mat(size, CV_8UC1, Scalar(128)), region_size);
            const Vec2d areas = extremeAreas(labels);
            EXPECT_GE(compactness(labels), 0.75) << size << ", " << region_size;
            EXPECT_GE(areas[0], 0.7) << size << ", " << region_size; // cells of 3x3 and of 4x4 blocks at 14
            EXPECT_LE(areas[1], 1.45) << size << ", " << region_size;
        }
}

// A tenth of the superpixels are tiles of whole cells. Their edges are straight where rows have equal numbers of cells.
TEST(ximgproc_SuperpixelGWatershed, tiles_of_cells_on_an_even_image_after_merging)
{
    const Size sizes[] = { Size(320, 240), Size(640, 480), Size(481, 321), Size(240, 320) };
    double means[2] = { 0, 0 };
    int cases = 0;
    for (const Size& size : sizes)
        for (int region_size : REGION_SIZES)
            for (int gray : { 3, 128, 203 })
            {
                const Mat image(size, CV_8UC1, Scalar(gray));
                const Mat tenth = mergedToATenth(image, region_size);
                EXPECT_GE(extremeAreas(tenth)[0], 0.6) << size << ", " << region_size << ", " << gray;
                EXPECT_LE(extremeAreas(tenth)[1], 1.5) << size << ", " << region_size << ", " << gray;
                EXPECT_GE(compactness(tenth), 0.7) << size << ", " << region_size << ", " << gray;

                const Mat merged = superpixels(image, region_size, 10, MERGED); // cells of 4 to 10 pixels
                EXPECT_GE(extremeAreas(merged)[0], 0.48) << size << ", " << region_size << ", " << gray;
                EXPECT_LE(extremeAreas(merged)[1], 1.6) << size << ", " << region_size << ", " << gray;
                EXPECT_GE(compactness(merged), 0.66) << size << ", " << region_size << ", " << gray;
                means[0] += compactness(tenth);
                means[1] += compactness(merged);
                cases++;
            }
    EXPECT_GE(means[0] / cases, 0.76);
    EXPECT_GE(means[1] / cases, 0.73);
}

TEST(ximgproc_SuperpixelGWatershed, no_part_of_a_cell_is_left_on_an_even_image)
{
    for (const Size& size : { Size(640, 480), Size(1280, 720) })
        for (int region_size : { 6, 7, 8, 9, 10, 11, 12, 15, 16, 18, 19, 22, 25, 28, 40 })
        {
            const Vec2d areas = extremeAreas(superpixels(Mat(size, CV_8UC3, Scalar(90, 120, 150)), region_size));
            EXPECT_GE(areas[0], 0.55) << size << ", " << region_size;
            EXPECT_LE(areas[1], 1.5) << size << ", " << region_size;
        }
}

//! From 0 to 255, rounded or cut off to whole levels, or 256 steps of equal length.
enum Levels { ROUNDED, CUT, EQUAL };

Mat makeRamp(Size size, Point direction, Levels levels = ROUNDED)
{
    Mat image(size, CV_8UC3);
    const double length = direction.x * (size.width - 1) + direction.y * (size.height - 1);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
        {
            const double part = (direction.x * x + direction.y * y) / length;
            const double level = levels == ROUNDED ? std::floor(255 * part + 0.5)
                               : levels == CUT ? std::floor(255 * part) : std::min(std::floor(256 * part), 255.);
            image.at<Vec3b>(y, x) = Vec3b::all(uchar(level));
        }
    return image;
}

//! One of six ramps: level, upright and slanted, without and with noise.
Mat makeRamp(int i, Size size = Size(640, 480))
{
    const Point directions[] = { Point(1, 0), Point(0, 1), Point(1, 1) };
    Mat image = makeRamp(size, directions[i / 2]);
    if (i % 2)
        addNoise(image, 1);
    return image;
}

TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_ramp)
{
    double means[2] = { 0, 0 }; // at the default ruler and at a large one
    for (int i = 0; i < 12; i++)
    {
        const Mat image = makeRamp(i % 6, i < 6 ? Size(640, 480) : Size(320, 240));
        for (int region_size : REGION_SIZES)
        {
            const double aspect = medianAspect(superpixels(image, region_size));
            means[0] += aspect;
            means[1] += medianAspect(superpixels(image, region_size, 40));
            EXPECT_LE(aspect, 1.6) << i << ", " << region_size;
        }
    }
    for (int i = 0; i < 6; i++)
        for (int region_size : { 35, 40, 50 })
            EXPECT_LE(medianAspect(superpixels(makeRamp(i), region_size)), 1.6) << i << ", " << region_size;
    EXPECT_LE(means[0] / 72, 1.15);
    EXPECT_LT(means[1], means[0]);
}

// Without noise, the rows of a ramp are all the same, and so are their superpixels: one that is a strip is in each row.
// Slopes of few blocks are rounded then, and differ from those beside them.
TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_clean_ramp)
{
    for (const Size& size : { Size(320, 240), Size(480, 320), Size(640, 480) })
        for (const Levels levels : { ROUNDED, CUT, EQUAL })
            for (const Point& direction : { Point(1, 0), Point(0, 1), Point(1, 1) })
            {
                const Mat image = makeRamp(size, direction, levels);
                for (int region_size : { 13, 14, 15, 16, 17, 18, 20, 21, 24, 30 })
                {
                    EXPECT_LE(medianAspect(superpixels(image, region_size)), 1.6)
                        << size << int(levels) << direction << ", " << region_size;
                    EXPECT_LE(medianAspect(mergedToATenth(image, region_size)), 1.6)
                        << size << int(levels) << direction << ", " << region_size;
                }
            }
}

// As many levels in fewer pixels.
TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_steep_ramp)
{
    double means[2] = { 0, 0 }; // of iterate() and after merging
    int count = 0;
    for (const Size& size : { Size(320, 240), Size(321, 481), Size(481, 321) })
        for (int region_size : REGION_SIZES)
            for (int i = 0; i < 6; i++, count++)
            {
                const Mat image = makeRamp(i, size);
                const double aspect = medianAspect(superpixels(image, region_size));
                const double merged = medianAspect(superpixels(image, region_size, 10, MERGED));
                EXPECT_LE(aspect, 1.8) << size << ", " << region_size << ", " << i; // at 13, with noise; else 1.6
                EXPECT_LE(merged, 1.6) << size << ", " << region_size << ", " << i;
                means[0] += aspect;
                means[1] += merged;
            }
    EXPECT_LE(means[0] / count, 1.2);
    EXPECT_LE(means[1] / count, 1.3);
}

// In a video, only what has changed is flooded and merged anew.
TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_ramp_that_appears)
{
    const Mat before = makePattern(BOARD, 40, false);
    const Rect changed(0, 0, 144, before.rows);
    double mean = 0;
    for (const Point& direction : { Point(1, 0), Point(0, 1) })
        for (int region_size : { 20, 24, 30, 35, 40 })
        {
            Mat after = before.clone();
            makeRamp(changed.size(), direction).copyTo(after(changed));
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(before, RGWATERSHED, region_size);
            gws->setTemporal(true);
            gws->iterate(before);
            gws->iterate(after);
            const Rect inside(0, 0, changed.width - region_size, changed.height);
            const double aspect = medianAspect(labelsOf(gws)(inside));
            EXPECT_LE(aspect, 2.5) << direction << ", " << region_size;
            mean += aspect / 10;
        }
    EXPECT_LE(mean, 1.8);
}

TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_ramp_after_merging)
{
    double mean = 0;
    for (int i = 0; i < 6; i++)
        for (int region_size : REGION_SIZES)
        {
            const double aspect = medianAspect(superpixels(makeRamp(i), region_size, 10, MERGED));
            mean += aspect / 36;
            EXPECT_LE(aspect, 1.6) << i << ", " << region_size;
        }
    EXPECT_LE(mean, 1.3);
}

// From one colour to another. Before chroma was part of slopes, the means were 4 and 11.
TEST(ximgproc_SuperpixelGWatershed, few_strips_on_a_ramp_of_colours)
{
    const Scalar colors[][2] = { { Scalar(255, 0, 0), Scalar(0, 0, 255) }, { Scalar(0, 255, 0), Scalar(255, 0, 255) },
                                 { Scalar::all(255), Scalar(0, 0, 255) } };
    double means[2] = { 0, 0 }; // of iterate() and after merging
    for (const auto& ends : colors)
        for (const Point& direction : { Point(1, 0), Point(0, 1), Point(1, 1) })
        {
            Mat steps, image;
            cv::multiply(makeRamp(Size(480, 320), direction), ends[1] - ends[0], steps, 1. / 255, CV_16S);
            cv::add(steps, ends[0], image, noArray(), CV_8U);
            for (int region_size : REGION_SIZES)
            {
                means[0] += medianAspect(superpixels(image, region_size)) / 54;
                means[1] += medianAspect(mergedToATenth(image, region_size)) / 54;
            }
        }
    EXPECT_LE(means[0], 2.2);
    EXPECT_LE(means[1], 2.1);
}

TEST(ximgproc_SuperpixelGWatershed, few_ramps_between_two_colours_become_strips)
{
    RNG& rng = theRNG();
    const int num_ramps = 150;
    int strips = 0;
    for (int i = 0; i < num_ramps; i++)
    {
        Mat colors(1, 2, CV_64FC3), ramp(240, 320, CV_64FC3), noise(ramp.size(), CV_64FC3), image;
        rng.fill(colors, RNG::UNIFORM, Scalar::all(0), Scalar::all(256));
        const Vec3d from = colors.at<Vec3d>(0), to = colors.at<Vec3d>(1);
        for (int x = 0; x < ramp.cols; x++)
            ramp.col(x).setTo(Scalar(from + (to - from) * (x / 319.)));
        rng.fill(noise, RNG::NORMAL, Scalar::all(0), Scalar::all(i % 2));
        cv::add(ramp, noise, image, noArray(), CV_8U);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 13 + 4 * (i % 3));
        gws->iterate();
        strips += medianAspect(labelsOf(gws)) > 1.6;
    }
    EXPECT_LE(strips, 0.3 * num_ramps); // over 320 pixels ramps are steep
}

TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_noisy_ramp_after_merging)
{
    double mean = 0;
    for (const Size& size : { Size(320, 240), Size(640, 480) })
        for (const Point& direction : { Point(1, 0), Point(0, 1), Point(1, 1) })
        {
            Mat image = makeRamp(size, direction), noise(size, CV_8SC3);
            theRNG().fill(noise, RNG::UNIFORM, -2, 3);
            cv::add(image, noise, image, noArray(), CV_8U);
            for (int region_size : REGION_SIZES)
            {
                const double aspect = medianAspect(superpixels(image, region_size, 10, MERGED));
                mean += aspect / 36;
                EXPECT_LE(aspect, 1.6) << size << direction << ", " << region_size;
            }
        }
    EXPECT_LE(mean, 1.3);
}

//! By how much compactness falls, at most, from one ruler to the next.
double largestFallOfCompactness(const Ptr<SuperpixelGWatershed>& gws, const Mat& image)
{
    double before = 0, fall = 0;
    for (float ruler : { 0.f, 1.f, 2.5f, 5.f, 10.f, 20.f, 40.f })
    {
        gws->setRuler(ruler);
        gws->iterate(image);
        const double now = compactness(labelsOf(gws));
        fall = std::max(fall, before - now);
        before = now;
    }
    return fall;
}

TEST(ximgproc_SuperpixelGWatershed, compactness_grows_with_the_ruler)
{
    const Size sizes[] = { Size(320, 240), Size(640, 480), Size(481, 321) };
    for (int i = 0; i < 15; i++)
    {
        const Mat image = i < 9 ? makeRamp(sizes[i / 3], Point(i % 3 != 1, i % 3 != 0))
                                : makeScene(Size(320, 240), theRNG());
        const int n = cvRound(double(image.total()) / (20 * 20));
        const Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, n);
        EXPECT_LE(largestFallOfCompactness(gws, image), 0.004) << i;
    }
}

// A small ruler makes the blocks of the flood smaller, which must not make superpixels more compact.
TEST(ximgproc_SuperpixelGWatershed, compactness_grows_with_the_ruler_in_textures)
{
    for (double blur : { 0.5, 1., 2., 3. })
    {
        Mat image(240, 320, CV_8UC3);
        theRNG().fill(image, RNG::UNIFORM, 0, 256);
        GaussianBlur(image, image, Size(), blur);
        normalize(image, image, 0, 255, NORM_MINMAX);
        for (int region_size : { 11, 13, 14, 17, 20, 21, 30 })
            for (int effort : { 0, 1 })
            {
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_size);
                gws->setEffort(effort);
                EXPECT_LE(largestFallOfCompactness(gws, image), 0.015) << blur << ", " << region_size << ", " << effort;
            }
    }
}

//! Share of the pixels of a line that are in superpixels most of whose pixels are of the line.
double shareInOwnSuperpixels(const Mat& labels, const Rect& line)
{
    const std::vector<std::vector<Point> > pixels = pixelsOf(labels);
    double share = 0;
    for (size_t i = 0; i < pixels.size(); i++)
    {
        const size_t count = std::count_if(pixels[i].begin(), pixels[i].end(),
                                           [&](const Point& p) { return line.contains(p); });
        share += 2 * count > pixels[i].size() ? double(count) / line.area() : 0;
    }
    return share;
}

//! The least of these shares for lines at all offsets to blocks of 3x3 and 4x4 pixels.
double leastShareOfLines(int width, int region_size, int times, const Scalar& color = Scalar(40, 40, 180))
{
    double least = 1;
    for (int offset = 0; offset < 12; offset++)
        for (int upright = 0; upright < 2; upright++)
        {
            Mat image(240, 320, CV_8UC3, Scalar::all(200));
            const Rect line = upright ? Rect(140 + offset, 0, width, 240) : Rect(0, 100 + offset, 320, width);
            image(line).setTo(color);
            least = std::min(least, shareInOwnSuperpixels(superpixels(image, region_size, 10, times), line));
        }
    return least;
}

TEST(ximgproc_SuperpixelGWatershed, thin_lines_have_superpixels_of_their_own)
{
    for (int width = 1; width <= 3; width++)
    {
        EXPECT_GE(leastShareOfLines(width, 12, 1), 0.9) << width;
        EXPECT_GE(leastShareOfLines(width, 13, 1), 0.9) << width;
        EXPECT_GE(leastShareOfLines(width, 13, 1, Scalar::all(150)), 0.9) << width;
        EXPECT_GE(leastShareOfLines(width, 20, 1), 0.9) << width;
        // Larger superpixels may lose them: four times as many, which are merged, do not.
        EXPECT_GE(leastShareOfLines(width, 30, 4), 0.9) << width;
        EXPECT_GE(leastShareOfLines(width, 40, 4), 0.9) << width;
    }
}

}} // namespace
