// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"

namespace opencv_test
{

static const int TILE_WIDTH = 320, TILE_HEIGHT = 240;

static const char* const PHOTOGRAPHS[] = {
    "aero1.jpg", "aero3.jpg", "aloeL.jpg", "apple.jpg", "baboon.jpg", "basketball1.png", "board.jpg",
    "box_in_scene.png", "building.jpg", "butterfly.jpg", "ela_original.jpg", "fruits.jpg", "graf1.png", "home.jpg",
    "left01.jpg", "lena.jpg", "leuvenA.jpg", "licenseplate_motion.jpg", "messi5.jpg", "orange.jpg",
    "rubberwhale1.png", "squirrel_cls.jpg", "starry_night.jpg", "stuff.jpg", "sudoku.png"
};

static Mat generateScene(RNG& rng)
{
    Mat scene(4 * TILE_HEIGHT, 4 * TILE_WIDTH, CV_8UC3);
    rng.fill(scene, RNG::UNIFORM, 0, 256);
    GaussianBlur(scene, scene, Size(), 2);
    for (int i = 0; i < 600; i++)
        circle(scene, Point(rng.uniform(0, scene.cols), rng.uniform(0, scene.rows)), rng.uniform(3, 60),
               Scalar(rng.uniform(0, 256), rng.uniform(0, 256), rng.uniform(0, 256)), FILLED);
    GaussianBlur(scene, scene, Size(3, 3), 0);
    return scene;
}

//! Cuts a picture into as many whole tiles as it has.
static void cutIntoTiles(const Mat& picture, std::vector<Mat>& tiles)
{
    for (int y = 0; y + TILE_HEIGHT <= picture.rows; y += TILE_HEIGHT)
        for (int x = 0; x + TILE_WIDTH <= picture.cols; x += TILE_WIDTH)
            tiles.push_back(picture(Rect(x, y, TILE_WIDTH, TILE_HEIGHT)));
}

static Mat readPicture(const String& name, int flags)
{
    const String path = samples::findFile(name, false, true);
    return path.empty() ? Mat() : imread(path, flags);
}

//! Tiles of all photographs, mixed.
static std::vector<Mat> makeImageTiles()
{
    RNG rng(7);
    std::vector<Mat> tiles;
    for (const char* name : PHOTOGRAPHS)
        cutIntoTiles(readPicture(name, IMREAD_COLOR), tiles);
    if (tiles.empty())
        for (int i = 0; i < 6; i++)
            cutIntoTiles(generateScene(rng), tiles);
    for (int i = int(tiles.size()) - 1; i > 0; i--)
        std::swap(tiles[i], tiles[rng.uniform(0, i + 1)]);
    return tiles;
}

static std::vector<Mat> makeDepthTiles()
{
    RNG rng(8);
    Mat disparity = readPicture("aloeGT.png", IMREAD_GRAYSCALE), depth;
    if (disparity.empty())
        cvtColor(generateScene(rng), disparity, COLOR_BGR2GRAY);
    disparity.convertTo(depth, CV_16U, 16);
    std::vector<Mat> tiles;
    cutIntoTiles(depth, tiles);
    return tiles;
}

//! Lays tiles in rows, from the first one on.
static Mat layTiles(const std::vector<Mat>& tiles, size_t first, Size size)
{
    Mat mosaic(size, tiles[0].type());
    for (int y = 0; y < size.height; y += TILE_HEIGHT)
        for (int x = 0; x < size.width; x += TILE_WIDTH)
        {
            const Rect place = Rect(x, y, TILE_WIDTH, TILE_HEIGHT) & Rect(Point(), size);
            tiles[first++ % tiles.size()](Rect(Point(), place.size())).copyTo(mosaic(place));
        }
    return mosaic;
}

Pictures::Pictures(Size size) : index_(0)
{
    static const std::vector<Mat> image_tiles = makeImageTiles(), depth_tiles = makeDepthTiles();
    const size_t count = size.area() > 3000000 ? 5 : 15; // the largest would take too much memory
    for (size_t i = 0; i < count; i++)
    {
        images_.push_back(layTiles(image_tiles, i * image_tiles.size() / count, size));
        depths_.push_back(layTiles(depth_tiles, i, size));
    }
}

Mat makeGridMarkers(Size size, int region_size)
{
    Mat markers = Mat::zeros(size, CV_32SC1);
    int count = 0;
    for (int y = region_size / 2; y < size.height; y += region_size)
        for (int x = region_size / 2; x < size.width; x += region_size)
            markers.at<int>(y, x) = ++count;
    return markers;
}

} // namespace
