// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Draws how RGWATERSHED works, as a strip of five pictures: blocks, markers, flood, merged, settled. The class makes
// all steps in one call; this sample calls the first ones one by one, so it needs the headers in src/.
// The picture of the tutorial: gwatershed_steps -i=fruits.jpg -x=340 -y=250 -o=gwatershed_steps.jpg

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <opencv2/gwatershed.hpp>

#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/block_markers.hpp"
#include "rgwatershed/block_texture.hpp"
#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/edge_blocks.hpp"
#include "rgwatershed/feature_pyramid.hpp"
#include "rgwatershed/region_flood.hpp"
#include "rgwatershed/region_labels.hpp"
#include "rgwatershed/similar_merge.hpp"
#include "rgwatershed/tuning.hpp"

#include <iostream>
#include <vector>

using namespace cv;
using namespace cv::ximgproc;

static const char* const KEYS =
    "{help h         |           | print this text }"
    "{i image        |           | image to segment }"
    "{o output       | steps.png | picture to write }"
    "{k superpixels  | 300       | number of superpixels }"
    "{x left         | 0         | first column of the part that is shown }"
    "{y top          | 0         | first row of the part that is shown }"
    "{s size         | 150       | width and height of the part that is shown, in pixels }";

enum { ZOOM = 2 };

//! What the steps give. flooded and merged are labels of blocks, settled are labels of pixels.
struct Steps
{
    int block; // width of a block in pixels
    std::vector<Point> markers;
    Mat flooded, merged, settled;
};

static Steps runSteps(const Mat& image, int num_superpixels)
{
    gws::Frame frame;
    frame.color = image;
    frame.num_pixels = int(image.total());
    frame.num_superpixels = num_superpixels;
    const gws::MaskPyramid no_mask;
    const gws::Plan plan(frame, gws::Parameters(), no_mask);
    Steps steps;
    steps.block = plan.levels.side(plan.levels.top);

    gws::PyramidLevel pyramid[gws::MAX_LEVEL + 1];
    gws::makePyramid(frame, false, plan.levels, no_mask, pyramid);
    gws::FeatureMap& blocks = pyramid[plan.levels.top];
    gws::Padded<int> labels;
    gws::clearLabels(blocks.size(), Mat(), labels);
    if (plan.takes_sides)
        gws::EdgeBlocks().takeSides(labels, blocks);

    Mat gradient;
    gws::BlockMarkers markers;
    gws::computeBlockGradient(blocks, plan.flood_distance, Mat(), gradient);
    gws::placeBlockMarkers(plan, blocks, image.size(), Mat(), gradient, markers);
    steps.markers = markers.places;

    gws::Regions regions;
    gws::FloodBuffers flood_buffers;
    const int num_markers = int(markers.places.size());
    gws::floodFromPoints(blocks, markers.places, markers.middles, markers.bands, plan.flood_distance,
                         plan.floodRuler(plan.blocks, num_markers), plan.usualFloodArea(plan.blocks, num_markers),
                         flood_buffers, labels, regions);
    steps.flooded = labels.view().clone();

    gws::BoundarySweeper sweeper;
    gws::MergeBuffers merge_buffers;
    if (regions.size() > plan.num_regions)
    {
        if (plan.sweeps_before_merging > 0)
            sweeper.sweepAll(plan.sweeps_before_merging, blocks, plan.sweep_before_merging, labels, regions);
        Mat buffer;
        gws::measureBlockTextures(pyramid, plan.levels, plan.flood_distance, labels, regions.size(), buffer,
                                  merge_buffers.textures);
        gws::MergeRules rules = plan.merge_rules;
        rules.in_cell = markers.in_cell;
        gws::mergeSimilarRegions(plan.num_regions, blocks, plan.flood_distance, rules, gws::UnionPlan(), merge_buffers,
                                 labels, regions);
    }
    steps.merged = labels.view().clone();

    Ptr<SuperpixelGWatershed> all = createSuperpixelGWatershed(image.cols, image.rows, 3, num_superpixels);
    all->iterate(image);
    all->getLabels(steps.settled);
    return steps;
}

//! Each element becomes a square of `factor` pixels in width.
static Mat enlarge(const Mat& small, int factor)
{
    Mat large;
    resize(small, large, Size(), factor, factor, INTER_NEAREST);
    return large;
}

//! An image with white lines between different labels.
static Mat drawBoundaries(const Mat& image, const Mat& labels)
{
    Mat picture = image.clone();
    for (int y = 0; y + 1 < labels.rows; y++)
        for (int x = 0; x + 1 < labels.cols; x++)
            if (labels.at<int>(y, x) != labels.at<int>(y, x + 1) || labels.at<int>(y, x) != labels.at<int>(y + 1, x))
                picture.at<Vec3b>(y, x) = Vec3b(255, 255, 255);
    return picture;
}

static Mat withTitle(const Mat& picture, const String& title)
{
    Mat result;
    copyMakeBorder(picture, result, 0, 30, 4, 4, BORDER_CONSTANT | BORDER_ISOLATED, Scalar::all(255));
    putText(result, title, Point(8, result.rows - 9), FONT_HERSHEY_SIMPLEX, 0.7, Scalar::all(0), 1, LINE_AA);
    return result;
}

//! The five pictures of a part of the image, side by side.
static Mat drawSteps(const Mat& image, const Steps& steps, const Rect& part)
{
    const int zoom_blocks = steps.block * ZOOM;
    Mat blocks;
    resize(image, blocks, steps.merged.size(), 0, 0, INTER_AREA);
    Mat marked = blocks.clone();
    for (size_t i = 0; i < steps.markers.size(); i++)
        marked.at<Vec3b>(steps.markers[i]) = Vec3b(255, 255, 255);
    blocks = enlarge(blocks, zoom_blocks);
    const Mat pictures[] = { blocks, enlarge(marked, zoom_blocks),
                             drawBoundaries(blocks, enlarge(steps.flooded, zoom_blocks)),
                             drawBoundaries(blocks, enlarge(steps.merged, zoom_blocks)),
                             drawBoundaries(enlarge(image, ZOOM), enlarge(steps.settled, ZOOM)) };
    const char* const titles[] = { "blocks", "markers", "flood", "merged", "settled" };
    const Rect shown(part.x * ZOOM, part.y * ZOOM, part.width * ZOOM, part.height * ZOOM);
    std::vector<Mat> columns;
    for (int i = 0; i < 5; i++)
        columns.push_back(withTitle(pictures[i](shown), titles[i]));
    Mat strip;
    hconcat(columns, strip);
    return strip;
}

int main(int argc, char** argv)
{
    CommandLineParser parser(argc, argv, KEYS);
    parser.about("Draws the steps of RGWATERSHED.");
    const String file = parser.get<String>("image"), output = parser.get<String>("output");
    const int num_superpixels = parser.get<int>("superpixels"), size = parser.get<int>("size");
    const Rect wanted(parser.get<int>("left"), parser.get<int>("top"), size, size);
    if (parser.has("help") || file.empty() || !parser.check())
    {
        parser.printErrors();
        parser.printMessage();
        return parser.has("help") ? 0 : 1;
    }
    Mat image = imread(file);
    if (image.empty())
    {
        std::cerr << "Cannot read " << file << std::endl;
        return 1;
    }
    const int largest_block = 12; // so that all blocks are whole ones
    if (image.cols < largest_block || image.rows < largest_block)
    {
        std::cerr << "The image needs 12x12 pixels at least" << std::endl;
        return 1;
    }
    image = image(Rect(0, 0, image.cols / largest_block * largest_block, image.rows / largest_block * largest_block));
    const Rect part = wanted & Rect(Point(), image.size());
    if (part.area() == 0 || num_superpixels < 1 || num_superpixels > int(image.total()))
    {
        std::cerr << "The part must lie in the image, and superpixels must be from 1 to its pixels" << std::endl;
        return 1;
    }
    const std::vector<int> quality = { IMWRITE_JPEG_QUALITY, 75 }; // no effect on .png
    if (!haveImageWriter(output) || !imwrite(output, drawSteps(image, runSteps(image, num_superpixels), part), quality))
    {
        std::cerr << "Cannot write " << output << std::endl;
        return 1;
    }
    std::cout << num_superpixels << " superpixels, " << output << std::endl;
    return 0;
}
