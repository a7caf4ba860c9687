// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/filesystem.hpp>
#include <opencv2/highgui.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <opencv2/gwatershed.hpp>

#include <algorithm>
#include <iostream>

using namespace cv;
using namespace cv::ximgproc;

static const char* const KEYS =
    "{help h         |     | print this text }"
    "{i image        |     | image to segment; without it, the camera }"
    "{d depth        |     | depth of -i, or the folder of depth of a folder -c: 8- or 16-bit, or float; 0 is missing }"
    "{o output       |     | segment -i without a window and write <o>_contours.png, <o>_mean.png, <o>_labels.png }"
    "{c camera       | 0   | camera id, video file, or folder of frames; openni2 or realsense: a camera with depth }"
    "{s region_size  | 20  | side of a superpixel in pixels }"
    "{k superpixels  | 0   | with -o: number of superpixels, instead of region_size if not 0 }"
    "{r ruler        | 10  | compactness }"
    "{e effort       | 1   | from 0, the fastest, to 3, the best }"
    "{a alpha        | 0.5 | weight of colour against depth }"
    "{f focal        | 0   | focal length of the depth camera in pixels; 0: 0.8 of the longer side of the image }"
    "{n iterations   | 1   | number of iterations }";

static Mat drawContours(const Mat& image, const SuperpixelGWatershed& gws)
{
    Mat result = image.clone(), contours;
    gws.getLabelContourMask(contours, false);
    result.setTo(Scalar(0, 0, 255), contours);
    return result;
}

static Mat drawMeans(const Mat& image, const SuperpixelGWatershed& gws)
{
    Mat labels, stats, centroids, means, result(image.size(), CV_8UC3);
    gws.getLabels(labels);
    gws.getStatistics(image, noArray(), stats, centroids, means, noArray());
    means.convertTo(means, CV_8U);
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
            result.at<Vec3b>(y, x) = Vec3b(means.ptr(labels.at<int>(y, x)));
    return result;
}

//! Colours that differ between most neighbours.
static Mat drawLabels(const SuperpixelGWatershed& gws)
{
    Mat labels, hue;
    gws.getLabels(labels);
    labels.forEach<int>([](int& label, const int*) { label = label * 67 & 255; });
    labels.convertTo(hue, CV_8U);
    applyColorMap(hue, hue, COLORMAP_HSV);
    return hue;
}

static void writePicture(const String& name, const Mat& picture)
{
    if (!imwrite(name, picture))
        CV_Error(Error::StsError, "cannot write " + name);
}

//! 16-bit PNG, or 32-bit TIFF where there are too many labels for that.
static String writeLabels(const String& prefix, const SuperpixelGWatershed& gws)
{
    Mat labels;
    gws.getLabels(labels);
    const bool fits = gws.getNumberOfSuperpixels() <= 65536;
    if (fits)
        labels.convertTo(labels, CV_16U);
    const String name = prefix + (fits ? "_labels.png" : "_labels.tiff");
    writePicture(name, labels);
    return name;
}

//! Segments one image a few times, writes the pictures and prints what it took.
static void segmentFile(const Mat& image, const Mat& depth, SuperpixelGWatershed& gws, int iterations,
                        const String& prefix)
{
    std::vector<double> times;
    for (int i = 0; i < 9; i++)
    {
        TickMeter timer;
        timer.start();
        if (depth.empty())
            gws.iterate(image, iterations);
        else
            gws.iterate(image, depth, iterations);
        timer.stop();
        times.push_back(timer.getTimeMilli());
    }
    std::nth_element(times.begin(), times.begin() + 4, times.end());

    writePicture(prefix + "_contours.png", drawContours(image, gws));
    writePicture(prefix + "_mean.png", drawMeans(image, gws));
    const String labels_name = writeLabels(prefix, gws);
    std::cout << image.cols << "x" << image.rows << (depth.empty() ? "" : " with depth") << ": "
              << gws.getNumberOfSuperpixels() << " superpixels in " << cvRound(times[4] * 100) / 100.
              << " ms (median of 9, " << getNumThreads() << " threads)\n"
              << "  " << prefix << "_contours.png, " << prefix << "_mean.png, " << labels_name << std::endl;
}

static Mat readPicture(const String& name, int mode)
{
    const Mat picture = imread(name, mode);
    if (picture.empty())
        CV_Error(Error::StsError, "cannot read the image " + name);
    return picture;
}

static bool isNumber(const String& text)
{
    const size_t MOST_DIGITS = 9;
    return !text.empty() && text.size() <= MOST_DIGITS && text.find_first_not_of("0123456789") == String::npos;
}

//! Frames of a camera or a video, or of two folders, or one image again and again.
class Source
{
public:
    Source(const Mat& image, const Mat& depth) : image_(image), depth_(depth) {}

    //! What is a folder has frames in the order of their names; that of depth may be left out.
    Source(const String& name, const String& depth_folder)
    {
        const bool is_folder = utils::fs::isDirectory(name);
        if (!is_folder && !depth_folder.empty())
            CV_Error(Error::StsBadArg, "-d needs an image, -i, or a folder of frames, -c");
        if (is_folder)
        {
            glob(name, colors_);
            if (!depth_folder.empty())
                glob(depth_folder, depths_);
            if (!depth_folder.empty() && depths_.empty())
                CV_Error(Error::StsBadArg, "there is no depth in the folder " + depth_folder);
        }
        else if (name == "openni2" || name == "realsense")
            openDepthCamera(name == "openni2");
        else
            isNumber(name) ? camera_.open(std::stoi(name)) : camera_.open(name);
    }

    bool isOpened() const { return camera_.isOpened() || !colors_.empty() || !image_.empty(); }
    bool isVideo() const { return image_.empty(); }

    //! depth stays empty if there is none.
    bool read(Mat& image, Mat& depth)
    {
        if (with_depth_)
            return camera_.grab() && camera_.retrieve(depth, depth_map_) && camera_.retrieve(image, color_map_);
        if (camera_.isOpened())
            return camera_.read(image);
        if (colors_.empty())
        {
            image = image_;
            depth = depth_;
            return true;
        }
        if (next_ == colors_.size() || (!depths_.empty() && next_ >= depths_.size()))
            return false;
        image = readPicture(colors_[next_], IMREAD_COLOR);
        if (!depths_.empty())
            depth = readPicture(depths_[next_], IMREAD_UNCHANGED);
        next_++;
        return true;
    }

private:
    //! Depth is in millimetres, and is brought to the places of colour where the camera can.
    void openDepthCamera(bool openni)
    {
        with_depth_ = camera_.open(openni ? CAP_OPENNI2 : CAP_REALSENSE);
        if (openni)
            camera_.set(CAP_PROP_OPENNI_REGISTRATION, 1);
        depth_map_ = openni ? int(CAP_OPENNI_DEPTH_MAP) : int(CAP_INTELPERC_DEPTH_MAP);
        color_map_ = openni ? int(CAP_OPENNI_BGR_IMAGE) : int(CAP_INTELPERC_IMAGE);
    }

    Mat image_, depth_;
    VideoCapture camera_;
    bool with_depth_ = false;
    int depth_map_ = 0, color_map_ = 0;
    std::vector<String> colors_, depths_;
    size_t next_ = 0;
};

//! What the trackbars of the window hold.
struct Settings
{
    int region_size, ruler, effort, alpha_percent, iterations, temporal, mode;
};

static void showWindow(Source& source, float focal, Settings settings)
{
    const String window = "gwatershed";
    namedWindow(window, WINDOW_AUTOSIZE);
    createTrackbar("Region size", window, &settings.region_size, 100);
    createTrackbar("Ruler", window, &settings.ruler, 50);
    createTrackbar("Effort", window, &settings.effort, 3);
    createTrackbar("Alpha %", window, &settings.alpha_percent, 100);
    createTrackbar("Iterations", window, &settings.iterations, 10);
    createTrackbar("Temporal", window, &settings.temporal, 1);
    createTrackbar("Mode", window, &settings.mode, 2); // contours, means, labels
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1, 1, 3, 1);
    gws->setFocalLength(focal);
    Mat image, depth;
    std::cout << "Mode 0: contours, 1: mean colours, 2: labels, which flicker less with Temporal 1. [q] or [esc] ends."
              << std::endl;
    for (int key = 0; key != 'q' && key != 27; key = waitKey(10) & 255)
    {
        if (!source.read(image, depth))
            break;
        gws->setRegionSize(std::max(1, settings.region_size));
        gws->setRuler(float(settings.ruler));
        gws->setEffort(settings.effort);
        gws->setAlpha(settings.alpha_percent / 100.f);
        gws->setTemporal(settings.temporal != 0);
        TickMeter timer;
        timer.start();
        if (depth.empty())
            gws->iterate(image, std::max(1, settings.iterations));
        else
            gws->iterate(image, depth, std::max(1, settings.iterations));
        timer.stop();

        Mat picture = settings.mode == 0 ? drawContours(image, *gws)
                    : settings.mode == 1 ? drawMeans(image, *gws) : drawLabels(*gws);
        putText(picture, format("%d in %.1f ms", gws->getNumberOfSuperpixels(), timer.getTimeMilli()),
                Point(8, 24), FONT_HERSHEY_SIMPLEX, 0.7, Scalar::all(255), 2);
        imshow(window, picture);
    }
}

int main(int argc, char** argv)
{
    CommandLineParser parser(argc, argv, KEYS);
    parser.about("Superpixels by a marker-controlled watershed, cv::ximgproc::SuperpixelGWatershed.\n"
                 "Values follow an equals sign: -i=image.jpg -o=result");
    if (parser.has("help"))
    {
        parser.printMessage();
        return 0;
    }
    const String image_file = parser.get<String>("image"), depth_file = parser.get<String>("depth");
    const String camera = parser.get<String>("camera"), output = parser.get<String>("output");
    const int num_superpixels = parser.get<int>("superpixels"), iterations = parser.get<int>("iterations");
    const float alpha = parser.get<float>("alpha"), ruler = parser.get<float>("ruler");
    const int region_size = parser.get<int>("region_size"), effort = parser.get<int>("effort");
    const float focal = parser.get<float>("focal");
    if (!parser.check())
    {
        parser.printErrors();
        return 2;
    }

    if (!output.empty() && image_file.empty())
    {
        std::cerr << "-o needs an image, -i" << std::endl;
        return 2;
    }

    Mat image, depth;
    if (!image_file.empty())
        image = imread(image_file, IMREAD_COLOR);
    if (!image.empty() && !depth_file.empty())
        depth = imread(depth_file, IMREAD_UNCHANGED);
    if ((!image_file.empty() && (image.empty() || (!depth_file.empty() && depth.empty()))) ||
        (!output.empty() && image.empty()))
    {
        std::cerr << "Cannot read the image " << image_file << " " << depth_file << std::endl;
        return 1;
    }
    try
    {
        if (!output.empty())
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_size, ruler);
            gws->setEffort(effort);
            gws->setAlpha(alpha);
            gws->setFocalLength(focal);
            if (num_superpixels != 0)
                gws->setDesiredSuperpixels(num_superpixels);
            segmentFile(image, depth, *gws, iterations, output);
            return 0;
        }
        Source source = image.empty() ? Source(camera, depth_file) : Source(image, depth);
        if (!source.isOpened())
        {
            std::cerr << "Cannot open the camera, the video or the folder " << camera << std::endl;
            return 1;
        }
        const Settings settings = { region_size, cvRound(ruler), effort, cvRound(alpha * 100), iterations,
                                    source.isVideo() ? 1 : 0, 0 };
        showWindow(source, focal, settings);
    }
    catch (const cv::Exception& e)
    {
        std::cerr << e.what() << std::endl;
        return 1;
    }
    return 0;
}
