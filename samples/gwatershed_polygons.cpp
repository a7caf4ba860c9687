// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <opencv2/gwatershed.hpp>

#include <fstream>
#include <iostream>

using namespace cv;
using namespace cv::ximgproc;

static const char* const KEYS =
    "{help h         |     | print this text }"
    "{i image        |     | image to segment }"
    "{o output       |     | file to write: .json, .yml or .xml }"
    "{p picture      |     | picture of the polygons to write }"
    "{k superpixels  | 400 | number of superpixels }";

struct Polygon
{
    bool is_hole;
    std::vector<Point> points;
};

/* The outline of a superpixel and its holes.

findContours() gives 8-connected borders that run through the centres of pixels: through those of the superpixel
itself, along its outline and around its holes. So the polygons of two neighbours lie one pixel apart, and so does a
hole from the superpixel that fills it. fillPoly() of all polygons of a superpixel, in one call, draws the
borders too and leaves the holes out: exactly the pixels of the superpixel. To paint the outline and then each hole
over it would take the pixels around the hole away. approxPolyDP() makes the polygons simpler. */
static std::vector<Polygon> findPolygons(const Mat& labels, int label, const Rect& box)
{
    const Mat mask = labels(box) == label;
    std::vector<std::vector<Point> > contours;
    std::vector<Vec4i> hierarchy;
    findContours(mask, contours, hierarchy, RETR_CCOMP, CHAIN_APPROX_SIMPLE, box.tl());
    std::vector<Polygon> polygons;
    for (size_t i = 0; i < contours.size(); i++)
    {
        // A contour with a parent is a hole.
        const Polygon polygon = { hierarchy[i][3] >= 0, contours[i] };
        polygons.push_back(polygon);
    }
    return polygons;
}

static void write(FileStorage& out, int label, const Mat& stats, const Mat& centroids, const Mat& colors,
                  const std::vector<Polygon>& polygons)
{
    out << "{" << "label" << label << "area" << stats.at<int>(label, CC_STAT_AREA);
    out << "centroid" << Point2d(centroids.at<double>(label, 0), centroids.at<double>(label, 1));
    out << "mean_color" << Vec3f(colors.ptr<float>(label));
    out << "polygons" << "[";
    for (size_t i = 0; i < polygons.size(); i++)
        out << "{" << "hole" << int(polygons[i].is_hole) << "points" << polygons[i].points << "}";
    out << "]" << "}";
}

//! Writes the polygons, draws them and returns how many there are.
static size_t writePolygons(const SuperpixelGWatershed& gws, const Mat& image, FileStorage& out,
                            Mat& picture)
{
    Mat labels, stats, centroids, colors;
    gws.getLabels(labels);
    gws.getStatistics(image, noArray(), stats, centroids, colors, noArray());
    size_t count = 0;
    picture = image.clone();
    out << "width" << image.cols << "height" << image.rows << "superpixels" << "[";
    for (int i = 0; i < stats.rows; i++)
    {
        const Rect box(stats.at<int>(i, CC_STAT_LEFT), stats.at<int>(i, CC_STAT_TOP),
                       stats.at<int>(i, CC_STAT_WIDTH), stats.at<int>(i, CC_STAT_HEIGHT));
        const std::vector<Polygon> polygons = findPolygons(labels, i, box);
        write(out, i, stats, centroids, colors, polygons);
        for (size_t j = 0; j < polygons.size(); j++)
            polylines(picture, polygons[j].points, true, polygons[j].is_hole ? Scalar(255, 0, 0) : Scalar(0, 0, 255));
        count += polygons.size();
    }
    out << "]";
    return count;
}

int main(int argc, char** argv)
{
    CommandLineParser parser(argc, argv, KEYS);
    parser.about("Superpixels as polygons: x, y, x, y, ... of the outlines and holes; colours are blue, green, red.");
    const String image_file = parser.get<String>("image"), output = parser.get<String>("output");
    const String picture_file = parser.get<String>("picture");
    const int num_superpixels = parser.get<int>("superpixels");
    if (parser.has("help") || image_file.empty() || output.empty() || !parser.check())
    {
        parser.printErrors();
        parser.printMessage();
        return parser.has("help") ? 0 : 1;
    }
    try
    {
        const Mat image = imread(image_file, IMREAD_COLOR);
        if (image.empty())
            CV_Error(Error::StsBadArg, "cannot read the image " + image_file);
        std::ofstream file(output.c_str());
        if (!file)
            CV_Error(Error::StsError, "cannot write " + output);
        FileStorage out(output, FileStorage::WRITE | FileStorage::MEMORY); // in a file it would not see a full disk

        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, num_superpixels);
        gws->iterate(image);
        Mat picture;
        const size_t count = writePolygons(*gws, image, out, picture);
        file << out.releaseAndGetString() << std::flush;
        if (!file)
            CV_Error(Error::StsError, "cannot write " + output);
        if (!picture_file.empty() && !imwrite(picture_file, picture))
            CV_Error(Error::StsError, "cannot write " + picture_file);
        std::cout << gws->getNumberOfSuperpixels() << " superpixels, " << count << " polygons" << std::endl;
    }
    catch (const cv::Exception& e)
    {
        std::cerr << e.what() << std::endl;
        return 1;
    }
    return 0;
}
