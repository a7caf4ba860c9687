// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SUPERPIXEL_GWATERSHED_HPP
#define OPENCV_GWATERSHED_SUPERPIXEL_GWATERSHED_HPP

#include "opencv2/core.hpp"

namespace cv
{
namespace ximgproc
{

//! @addtogroup gwatershed
//! @{

//! Algorithms of SuperpixelGWatershed.
enum GWatershedType
{
    //! Algorithm 1 of @cite Jiang2015 , for comparison: the priority of a pixel is its distance to the neighbour
    //! from which the flood reaches it. One pass; `ruler` and `num_iterations` have no effect.
    GWATERSHED = 200,
    //! Region-guided watershed, the default: the priority of a pixel is its distance to the mean of the region
    //! that reaches it. Better than GWATERSHED in every measure of quality but compactness.
    RGWATERSHED = 201
};

/** @brief Superpixels by a marker-controlled watershed on a gradient map @cite Jiang2015 .

@code{.cpp}
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 20);
    gws->iterate();
    Mat labels, contours;
    gws->getLabels(labels);             // CV_32SC1, 0 .. gws->getNumberOfSuperpixels() - 1
    gws->getLabelContourMask(contours); // CV_8UC1, 255 on the contours
    gws->iterate(next_image);           // the next frame, of any size
    gws->iterate(next_image, depth);    // a frame with depth
@endcode

![Contours, mean colours, and an image with depth](pics/gwatershed_demo.jpg)

**RGWATERSHED**, the default, is the method to use. Its steps:
1. Features: lightness, two colour differences and depth of each pixel. Where superpixels are large enough, means of
   blocks of 2x2 to 4x4 pixels. If 12 or more of these fit in, without depth or video, those on an edge take a side.
2. Markers: four for each superpixel, fewer for small ones, one if it has less than 6x6 pixels, each in a cell of a
   grid, away from high gradients.
3. Flood: each marker grows into a region. Blocks wait in first-in first-out queues, one queue for each
   priority. The priority of a block is its distance to the mean of the region that reaches it, plus a part
   that grows with its distance to the marker.
4. Merging down to the number of superpixels: neighbours that are similar in colour and texture become one.
5. Sweeps: each block, and later each pixel, on a boundary may move to the neighbouring region, if that is nearer
   in colour and depth or makes the boundary shorter. Each further iteration sweeps more.

**GWATERSHED** is Algorithm 1 of the paper, for comparison: a gradient map, one marker at a low gradient for each
superpixel, and a flood with the distances of equations (1) to (4) as priorities. It leaves lines where two floods meet.
One step is added: at the end each pixel of a line joins the most similar neighbour.

**Result.** Every pixel has a label, the labels are 0 to N - 1 without gaps, and the pixels of one label are
one 4-connected component. Labels run from top to bottom, roughly: by the first cell of the grid of markers that is in
a superpixel. The result depends on the image, the depth and the parameters only: it is the same for any number of
threads, in every run, and for a submatrix and its clone. Exceptions, each described with its method: pixels without a
label, which are -1 (setMask(), setMarkers()), and results that depend on earlier frames (setTemporal()).

**Images** have any depth from CV_8U to CV_16F and 1 to 4 channels, as Mat or UMat. The fourth channel is ignored. The
image is reduced to 8 bits; setValueRange() says how. Three channels are BGR: RGWATERSHED converts them itself, so give
it images as imread() returns them, or see setLabInput(). GWATERSHED compares the channels as they are. Two channels
count alike in RGWATERSHED, up to rounding, which moves a sixth of the boundaries if they are exchanged; the gradient of
GWATERSHED is one of grey, which weighs them, see setBorderThreshold(). If there are more, choose some by
cv::extractChannel(), or reduce them by cv::PCA. Images have (width + 2) * (height + 2) < 2^31 - 3, sides < 2^29 - 16.

**Depth** has the size of the image. It is CV_16UC1 (usually in millimetres), CV_32FC1 or CV_64FC1 (usually in metres),
CV_16SC1 (the disparity of cv::StereoSGBM, with minDisparity 0) or CV_8UC1 (already scaled, unless a range is set).
Where it is 0, negative or NaN, or 65535 in CV_16UC1, depth is missing and colour alone counts. Infinity is farther than
all else, or as far as the far end of setDepthRange(). Read depth with IMREAD_UNCHANGED. Of inverse depth w, as networks
give it, pass 1 / (w - min + (max - min) / 2) as CV_32FC1: as it is, it would be taken for metric depth. Depth that is
missing or the same everywhere changes nothing.

**Errors.** A wrong argument throws cv::Exception, with the name of the argument, and nothing is changed. If
memory runs out, cv::Exception with Error::StsNoMem is thrown; after that in iterate(), there is no segmentation
and empty() returns true. The object can be used again in both cases. Input images are never written to. In Python None
for depth is no depth. None for a number is its default, or 0 if it has none: `iterate(None)` is `iterate()`, so check
what imread() returned. After None for depth a region_size of 200 or 201 is taken for the algorithm: leave depth out.

**Outputs** are a Mat or UMat, allocated as needed, or a Mat_ of the type stated. What has one column, and the labels
and masks of an image of one row, may also be a std::vector of that type.

**Threads.** Most steps run under cv::parallel_for_. The flood of GWATERSHED runs on the calling thread, and so
does that of RGWATERSHED with a mask, with user markers or with setDepthAdaptive(true). Different objects can be used in
different threads at the same time. One object can not, except for its const methods: the second call throws.

**Algorithm.** write() and read() store and restore the parameters: `gws->read(storage[gws->getDefaultName()])`, not
Algorithm::load(). read() throws, and changes nothing, if one is missing or out of its range. clear() drops the
segmentation, the image of the factory, the mask, the markers and the buffers, and keeps the parameters. empty() is true
while there is no segmentation.

**Cost.** Time and memory grow linearly with the number of pixels. Each superpixel adds about a microsecond, and one to
three in mergeSimilar() and mergeSmall(). Buffers are kept until clear(): 16 to 70 bytes for each pixel (1x1: 163), up
to eight times as much with small superpixels and an effort of 2 or 3. mergeSimilar() takes 4 bytes more for each pixel,
until the next iterate(), and up to 1100 for each superpixel, kept unless superpixels have less than 17 pixels.
*/
class CV_EXPORTS_W SuperpixelGWatershed : public Algorithm
{
public:
    /** @brief Number of superpixels N of the current segmentation, 0 before the first iterate().

    N is the number asked for, or the number of pixels if that is smaller. mergeSimilar() sets a lower one;
    enforceLabelConnectivity() and mergeSmall() may reduce it. With a mask or markers see setMask() and setMarkers().
    */
    CV_WRAP virtual int getNumberOfSuperpixels() const = 0;

    /** @brief Segments the image, and its depth, that were given to the factory.

    The factory made a copy of them; iterate() of another image does not replace it. Each call starts from the
    beginning with the current parameters, unless setTemporal() is on.

    @param num_iterations Number of iterations, 1 or more. For RGWATERSHED each iteration after the first moves more
    boundary pixels, and only where the mean colours of the superpixels explain the image as well or better afterwards:
    the explained variation of the 8-bit image (of two channels, with their mean as a third) never falls. The time of an
    iteration is proportional to the boundary that still moves; when nothing moves, the rest are skipped. From the 17th
    iteration on no pixel moves because of depth alone. GWATERSHED makes one pass for any number.

    ![After 1, 2, 4 and 8 iterations](pics/gwatershed_iterations.jpg)

    Throws cv::Exception if the factory was given a size instead of an image, and after clear().
    */
    CV_WRAP virtual void iterate(int num_iterations = 1) = 0;

    /** @overload
    @brief Segments another image, of any size and of any type that the class documentation lists.
    @param image Image to segment. It is not kept.
    @param num_iterations Number of iterations, 1 or more.
    */
    CV_WRAP virtual void iterate(InputArray image, int num_iterations = 1) = 0;

    /** @overload
    @brief Segments another image with its depth.
    @param image Image to segment. It is not kept.
    @param depth Depth map of the size of the image, of a type named above. It is not kept. Empty (noArray(), None in
    Python): colour alone.
    @param num_iterations Number of iterations, 1 or more.
    */
    CV_WRAP virtual void iterate(InputArray image, InputArray depth, int num_iterations = 1) = 0;

    /** @brief Returns a copy of the label map.

    @param labels_out CV_32SC1 map of the size of the image, values in [0, N). -1 outside of a mask and where no
    user marker reaches.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getLabels(OutputArray labels_out) const = 0;

    /** @brief Returns the contours of the superpixels as a mask.

    @param image CV_8UC1 mask of the size of the image: 255 on contours, 0 elsewhere.
    @param thick_line If true, a pixel is on a contour if one of its 4 neighbours has another label: lines are two
    pixels wide (those of SLIC and SEEDS are one). If false, if its right or lower neighbour has: lines are one pixel
    wide, and part of the thick ones. There is no contour at the border of the image, nor beside pixels without label.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getLabelContourMask(OutputArray image, bool thick_line = true) const = 0;

    /** @brief Returns the watershed lines of GWATERSHED, before their pixels joined superpixels.

    @param image CV_8UC1 mask of the size of the image: 255 where two floods met, where the gradient reached the
    border threshold, and on pixels enclosed by these; 0 elsewhere, and on markers, which may lie side by side.
    RGWATERSHED makes no lines: 0 everywhere.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getWatershedLineMask(OutputArray image) const = 0;

    /** @brief Merges superpixels that are too small into a neighbour.

    Superpixels are connected without this call. The smallest superpixel is merged first, into the neighbour with the
    longest common boundary for its size (squared length over area). N falls; labels keep their order, without gaps.

    @param min_element_size Smallest area allowed, in percent of the mean area (labelled pixels / N), in [0, 100]. 0
    merges nothing. A superpixel without a neighbour stays.

    Throws cv::Exception before the first iterate(). */
    CV_WRAP virtual void enforceLabelConnectivity(int min_element_size = 25) = 0;

    /** @brief Merges superpixels below an area in pixels into a neighbour, as enforceLabelConnectivity() does.
    @param min_area Smallest area allowed, in pixels, 0 or more. A superpixel without a neighbour stays as it is.
    Throws cv::Exception before the first iterate(). */
    CV_WRAP virtual void mergeSmall(int min_area) = 0;

    //! @name After the segmentation
    //! @{

    /** @brief Merges similar neighbouring superpixels until a number is left.

    @code{.cpp}
        gws->iterate(image);         // 1600 superpixels
        gws->mergeSimilar(400);
        gws->getLabels(coarse);
        gws->mergeSimilar(800);      // back to a finer level of the same hierarchy
    @endcode

    The first call after iterate() finds the order of all unions; each call applies the first part of it. So partitions
    for all numbers are nested, and later calls cost little more than writing labels. Superpixels stay connected.
    Labels keep their order, without gaps. enforceLabelConnectivity() and mergeSmall() start a new order if they merge.

    Without depth, superpixels that are nothing but an edge, up to two pixels wide and of a colour between those of both
    sides, join a side first. Then cheap pairs merge, in rounds. The cost of a pair is Ward's criterion
    @cite Beaulieu1989 with more factors, as a product of powers: the contrast across the common boundary and its
    length, the textures of both and their directions, lightness, chroma, what lies around (without depth), and the area
    of the union, never more than 4 times the mean while there are others. On a slope that both are parts of, all
    directions cost alike. Distances are those of RGWATERSHED, with surfaces if there are any; alpha weighs depth. Where
    colours are equal, a plan decides: the image is divided into tiles of ten superpixels, and these into halves.
    @param num_superpixels Number to reach, 1 or more. N stays larger if the remaining superpixels do not touch, as
    in the components of a mask. If iterate() gave no more than that, nothing is merged.

    Throws cv::Exception before the first iterate(). */
    CV_WRAP virtual void mergeSimilar(int num_superpixels) = 0;

    /** @brief Measures all superpixels in one pass: area, bounding box, centroid, mean colour, mean depth, surface.

    @code{.cpp}
        gws->getStatistics(image, noArray(), stats, centroids, mean_colors);
        gws->getStatistics(image, depth, stats, centroids, mean_colors, mean_depths, positions, normals);
    @endcode

    @param image Image of the size of the label map, of any type but 64-bit integers: the one that was segmented, or
    another one, such as optical flow or normals. Empty (noArray(), None in Python): no mean colours.
    @param depth Depth map of the same size, of a type that iterate() takes; metric where positions and normals are
    asked for. Empty: no mean depths, positions and normals.
    @param stats N x 5 CV_32SC1, one row for each superpixel, in pixels. The columns are those of
    connectedComponentsWithStats(): CC_STAT_LEFT, CC_STAT_TOP, CC_STAT_WIDTH, CC_STAT_HEIGHT, CC_STAT_AREA.
    @param centroids N x 2 CV_64FC1, x and y in pixels.
    @param mean_colors N x C CV_32FC1, one column for each channel, in the unit of image, over its finite values.
    @param mean_depths N x 1 CV_32FC1, in the unit of depth, over the pixels with depth, finite as a float.
    @param positions N x 3 CV_32FC1, the mean of the points in space at these pixels: x to the right, y down and z
    forward from the camera, in the unit of depth. z is the mean depth.
    @param normals N x 3 CV_32FC1, x, y and z of a vector of length 1, towards the camera: the normal of the plane that
    fits the inverse of these depths best.

    The focal length of positions and normals is that of setFocalLength() at the last iterate(), or, if that was 0, 0.8
    of the longer side of the image; the optical axis meets the middle of the image. A mask changes neither of them.

    Any table can be left out by noArray(); means, positions and normals take no time then. Means and positions are NaN
    if there is nothing to take them from, and normals if all pixels with depth are on one line, or nearly. A table of
    what was not given has no rows. In Python all are returned, and one without rows is None. Throws cv::Exception
    before the first iterate().
    */
    CV_WRAP virtual void getStatistics(InputArray image, InputArray depth, OutputArray stats, OutputArray centroids,
                                       OutputArray mean_colors = noArray(), OutputArray mean_depths = noArray(),
                                       OutputArray positions = noArray(), OutputArray normals = noArray()) const = 0;

    /** @brief Lists the superpixels that touch: the region adjacency graph.

    @param image Image of the size of the label map, of a type that iterate() takes, for the contrasts: the one that
    was segmented, or another one. Empty (noArray(), None in Python): no contrasts. It is reduced to 8 bits.
    @param depth Depth of that image; empty: colour alone. It must be empty if image is. Value range, depth range and
    alpha are those of the last iterate(); an automatic range is that of the image or depth given here.
    @param pairs M x 2 CV_32SC1: labels a < b of two superpixels that share a boundary (4-neighbours), in rows
    sorted by a, then b.
    @param lengths M x 1 CV_32SC1, length of the boundary in pixel edges.
    @param contrasts M x 1 CV_32FC1, contrast of the boundary, 0 to 255: the mean over its pixel edges of the distance
    of the two pixels, equations (1) to (3) of the paper: alpha times the largest difference of a channel plus 1 - alpha
    times that of scaled depth, in whole levels; where depth is missing, the difference of the channel alone.

    Without a mask or user markers the graph is connected. A table without rows is None in Python. Throws
    cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getAdjacency(InputArray image, InputArray depth, OutputArray pairs, OutputArray lengths,
                                      OutputArray contrasts = noArray()) const = 0;

    //! @}

    //! @name What to segment. Takes effect at the next iterate().
    //! @{

    /** @brief Restricts the segmentation to a part of the images to come.

    Pixels outside have the label -1, are 0 in the masks of contours and lines, and have no influence on the pixels
    inside. The number of superpixels and the region size count pixels inside only. Every connected component of the
    mask has at least one superpixel: N is the number asked for, one for each pixel at most, or the number of
    components, whichever is larger. Labels follow the order of the components, as far as blocks of pixels show it;
    parts too small for a block come last. If the mask is zero everywhere, N = 0.

    @param mask CV_8UC1, or CV_BoolC1 in OpenCV 5, non-zero inside, or empty for no mask. Before OpenCV 5, in Python,
    give `inside.astype(np.uint8)` of a boolean array. It is copied, and kept until the next setMask() or clear().
    iterate() throws if its size is not that of the image.
    */
    CV_WRAP virtual void setMask(InputArray mask) = 0;

    /** @brief Sets the markers that superpixels grow from, as for cv::watershed.

    N is the number of different positive values inside of the mask. Labels follow the order of the values; the number
    of superpixels and the region size are ignored. All pixels of a marker stay in its superpixel. Markers may touch
    each other and the border of the image. A marker in several pieces makes a superpixel in several pieces, at most as
    many. What no marker reaches, in other components of a mask, has the label -1. RGWATERSHED floods pixels then, which
    takes longer. Fewer than 32 markers may have many colours each: their parts, in cells of 8x8 pixels, grow by means
    of their own. Of 32 or more each has one mean, and a ruler if none is above 1/8 of the mean area.

    @param markers CV_32SC1: positive values are markers, all others unknown (add 1 to a label map of getLabels()).
    Empty for none. It is copied, and kept until the next setMarkers() or clear(). iterate() throws if the size differs.
    */
    CV_WRAP virtual void setMarkers(InputArray markers) = 0;

    //! @}

    //! @name Parameters. They take effect at the next iterate(). A value out of its range throws cv::Exception.
    //! Without an argument, where that can be, a setter sets the default.
    //! @{

    /** @brief Sets the algorithm.
    @param algorithm One of #GWatershedType. Default RGWATERSHED. */
    CV_WRAP virtual void setAlgorithm(int algorithm = RGWATERSHED) = 0;
    /** @brief The algorithm, one of #GWatershedType. @see setAlgorithm */
    CV_WRAP virtual int getAlgorithm() const = 0;

    /** @brief Asks for superpixels of a mean size; replaces setDesiredSuperpixels().
    @param region_size Side in pixels of a square of the mean area of a superpixel, 1 or more. Default 10. Their
    number is W * H / region_size^2, changed by up to 5 % so that rows and columns are full where that can be. */
    CV_WRAP virtual void setRegionSize(int region_size = 10) = 0;
    /** @brief Region size in pixels, or 0 if a number of superpixels is asked for. @see setRegionSize */
    CV_WRAP virtual int getRegionSize() const = 0;

    /** @brief Asks for a number of superpixels; replaces setRegionSize().
    @param num_superpixels Number of superpixels, 1 or more. It is met exactly; an image with fewer pixels gets one
    superpixel for each pixel. */
    CV_WRAP virtual void setDesiredSuperpixels(int num_superpixels) = 0;
    /** @brief Number asked for, or 0 if a region size is asked for. @see setDesiredSuperpixels */
    CV_WRAP virtual int getDesiredSuperpixels() const = 0;

    /** @brief Sets the compactness.
    @param ruler 0 or more, finite. Default 10, the best all-round setting. 0 follows the image alone, and boundaries
    are ragged. Small values give high boundary recall, larger ones more compact superpixels, though never squares.
    Images that are faint all over are followed all the same. The effect depends little on the size of superpixels, from
    10x10 pixels on, and, with the same setValueRange(), not on the bit depth of the image. GWATERSHED ignores it.

    ![ruler from 0 to 40](pics/gwatershed_ruler.jpg) */
    CV_WRAP virtual void setRuler(float ruler = 10.0f) = 0;
    /** @brief The compactness. @see setRuler */
    CV_WRAP virtual float getRuler() const = 0;

    /** @brief Sets how much time RGWATERSHED takes for better superpixels.
    @param effort 0, 1, 2 or 3; default 1. GWATERSHED ignores it.

    | effort | flood and merging | time | UE |
    |---|---|---|---|
    | 0 | fewer markers; below 14x14 pixels mostly larger blocks, too | 0.83 | 0.0672 |
    | 1 | as the class documentation says | 1 | 0.0633 |
    | 2 | smaller blocks, up to eight markers for each superpixel | 2 | 0.0612 |
    | 3 | up to ten markers, and the last regions are merged when boundaries are settled to the pixel | 3.2 | 0.0584 |

    Time is relative to 1; smaller superpixels than 6x6 pixels take up to 17 times that of 1 with 2 and 3. UE is that of
    400 superpixels on BSDS500 (train). In temporal mode, and where setDepthAdaptive(true) acts, 3 is the same as 2;
    with 8x8, 5x5, 4x4, 2x2 and 1x1 pixels 0 is the same as 1. With user markers effort has no effect. */
    CV_WRAP virtual void setEffort(int effort = 1) = 0;
    /** @brief The effort. @see setEffort */
    CV_WRAP virtual int getEffort() const = 0;

    /** @brief Sets the weight of colour against depth, equation (3) of the paper.
    @param alpha In [0, 1]: Dist = alpha * Dist_RGB + (1 - alpha) * Dist_D. 1 is colour alone, 0 is depth alone where
    there is depth. Default 0.5, as in the paper; take less where colour misleads. Without depth it has no effect.
    Iterations after the first never move a pixel to a region whose colour is farther, for any alpha.
    @note RGWATERSHED divides by the larger of the two weights, so that distances with and without depth compare, and
    takes the smaller one in steps of 1/256. GWATERSHED and getAdjacency() take alpha in such steps.

    ![alpha from 1, colour alone, to 0, depth alone](pics/gwatershed_alpha.jpg) */
    CV_WRAP virtual void setAlpha(float alpha = 0.5f) = 0;
    /** @brief The weight of colour against depth. @see setAlpha */
    CV_WRAP virtual float getAlpha() const = 0;

    /** @brief Tells that images are in CIELAB or a similar space instead of BGR.
    @param lab_input If false, the default, images of three channels are BGR and RGWATERSHED converts them to its
    opponent space. If true, it takes the channels as they are: lightness and two colour differences, as CIELAB from
    cv::cvtColor. That of floats follows colour more than that of 8 bits, where cvtColor() stretches lightness.
    GWATERSHED never converts. It has no effect on one and two channels. */
    CV_WRAP virtual void setLabInput(bool lab_input) = 0;
    /** @brief Whether images are in CIELAB or a similar space. @see setLabInput */
    CV_WRAP virtual bool getLabInput() const = 0;

    /** @brief Sets whether superpixels keep their labels from frame to frame.
    @param temporal If false, the default, each frame is segmented by itself. If true, each iterate() of an
    image continues the last segmentation: a superpixel keeps its label as long as it can be followed, over
    motions of less than a quarter of its side from frame to frame.

    RGWATERSHED moves the boundaries to where things are now. Superpixels that explain the image much worse than when
    they were made are replaced: their pixels form as many new ones, which take over their labels, so N stays the same.
    If superpixels that explain it much worse cover more than half of the image, or if the last frame was noise beside
    this one, all start again. GWATERSHED moves each marker to the middle of its last region; the markers of regions
    that have become small, below a quarter of the mean area, move into the largest ones. Boundaries also move a little
    on a still image. Normals of RGWATERSHED that are new in each frame, as those of stereo, count less.

    A frame starts from the beginning if it is the first one, or the first after clear(), setMask() of another mask or
    a frame that was not temporal; if its size, algorithm or number of superpixels is not that of the last frame; if one
    of these frames has user markers; and, for RGWATERSHED, if a new ruler or effort changes the size of the blocks, or
    if depth with normals comes or goes and these blocks do not divide the image evenly.
    @note mergeSimilar() and the like renumber the labels of one frame only: the next one continues from iterate(). */
    CV_WRAP virtual void setTemporal(bool temporal) = 0;
    /** @brief Whether superpixels keep their labels from frame to frame. @see setTemporal */
    CV_WRAP virtual bool getTemporal() const = 0;

    /** @brief Sets the range of values that becomes 0 to 255.

    The map is the same for all channels, so that distances stay in proportion.

    @param low_value Value that becomes 0. Lower values and NaN become 0, too.
    @param high_value Value that becomes 255. Higher values become 255, too. low_value < high_value, finite; or both 0,
    the default, for the usual range: 0 to 255 for CV_8U, to 255, 511, 1023, ... or 65535 for CV_16U, the first one that
    holds all values but one in 1000 (65535 if all are multiples of 257: 8 bits spread over 16); -128 to 127 for CV_8S,
    0 to 1 for floats, also if up to an eighth of those that are not 0 lie outside, some at 4 or more, as lights. Else
    the range is that of the finite values of the frame, or of a sample, without one in 1000 at each end: always for
    CV_16S and CV_32S, and if more than one value in 1000 is outside of the usual one, or the others span less than a
    sixteenth of it (not for CV_8U) or, of CV_16U above 255, less than half of the lowest one, as raw thermal images.
    @note The range may change from frame to frame. Set it for a video, as 0 and 4095 for 12 bits, where more than one
    pixel in 1000 is saturated, for 8 bits of few values, and for floats of a small range. */
    CV_WRAP virtual void setValueRange(float low_value, float high_value) = 0;
    /** @brief The value that becomes 0, or 0 if the range is automatic. @see setValueRange */
    CV_WRAP virtual float getLowValue() const = 0;
    /** @brief The value that becomes 255, or 0 if the range is automatic. @see setValueRange */
    CV_WRAP virtual float getHighValue() const = 0;

    /** @brief Sets the range of depth that is scaled to the 1..255 of equation (2).

    @param near_depth Depth that becomes 1, in the unit of the depth map. Nearer depth becomes 1, too.
    @param far_depth Depth that becomes 255. Farther depth becomes 255, too. 0 <= near_depth < far_depth, finite; or
    both 0, the default, for the range of the frame: from the 1st to the 99th percentile of its valid depths (of a
    sample if there are many), or from minimum to maximum if these are equal. A gap without depths that takes 7/8 of
    that range gets fewer levels, and so does noise (with surfaces in any range): two neighbours differ by 20 in the
    median at most. CV_8UC1 is taken as it is if both are 0; CV_64FC1 is read as CV_32FC1. For a video set a range.
    @note Where surfaces are measured (setFocalLength()), the range is one of inverse depth, in which what is far takes
    few levels and what is near takes them from all else: steps of a colour must be 2 % of the depth to be found at the
    near end, 20, 40 and 80 % at 4, 8 and 16 times its depth, and 1/2500 of the inverse near end at least. The near end
    is the nearest thousandth, not the hundredth, but at most a quarter of the range nearer; a near_depth below half of
    it counts as half. What is 64 times as far as the middle of the depths that differ counts as infinite, if it is more
    than a hundredth. Up to a seventh of the depths that lie apart, as a gripper, count as nearer than all others. */
    CV_WRAP virtual void setDepthRange(float near_depth, float far_depth) = 0;
    /** @brief The depth that becomes 1, or 0 if the range is taken from the frame. @see setDepthRange */
    CV_WRAP virtual float getNearDepth() const = 0;
    /** @brief The depth that becomes 255, or 0 if the range is taken from the frame. @see setDepthRange */
    CV_WRAP virtual float getFarDepth() const = 0;

    /** @brief Sets the focal length of the depth camera, from which RGWATERSHED takes the directions of surfaces.

    With metric depth RGWATERSHED compares surfaces, not depths alone: blocks of pixels have normals, and the depth of a
    pixel is measured against the plane of a superpixel. So a table seen at an angle is not cut into stripes of equal
    depth, and two walls of one colour are cut where they meet. Depth counts by its inverse, whose noise is the same
    near and far. The unit of depth does not matter. Where no normal can be had, beside holes, depth and colour count.
    @param fx Focal length in pixels of the image, 0 or more, finite. If 0, the default, it is 0.8 of the longer side of
    the image, or of the bounds of a mask, which is near to that of usual sensors (Kinect 0.82, RealSense D435 0.72),
    for CV_16UC1, CV_32FC1 and CV_64FC1. Other depth, which is scaled already or a disparity, has no normals then: leave
    0 for it. Images, or bounds of a mask, with a side below 16 or above 32767 pixels have no normals either. The
    optical axis meets the middle of the image, at ((width - 1) / 2, (height - 1) / 2), or that of the bounds of a mask.
    Set the focal length for parts of an image, and for other lenses.
    @param fy The same along y, 0 or more, finite. If 0, the default, it is fx. It must be 0 if fx is.
    @see setNormalWeight */
    CV_WRAP virtual void setFocalLength(float fx, float fy = 0.0f) = 0;
    /** @brief The focal length along x in pixels, or 0 if it is the usual one. @see setFocalLength */
    CV_WRAP virtual float getFocalLengthX() const = 0;
    /** @brief The focal length along y in pixels, or 0 if it is that along x. @see setFocalLength */
    CV_WRAP virtual float getFocalLengthY() const = 0;

    /** @brief Sets the weight of normals against depth.
    @param normal_weight In [0, 1], default 0.2: the distance of surfaces is normal_weight * Dist_N +
    (1 - normal_weight) * Dist_D. More of it cuts at smaller bends, and follows the noise of depth more. 0 switches
    surfaces off: depth is compared as it is, scaled from near to far, as for 8-bit depth. GWATERSHED ignores it.
    @note With surfaces, depth and normals count twice as much beside colour as depth alone does. */
    CV_WRAP virtual void setNormalWeight(float normal_weight = 0.2f) = 0;
    /** @brief The weight of normals against depth. @see setNormalWeight */
    CV_WRAP virtual float getNormalWeight() const = 0;

    /** @brief Sets whether superpixels have about the same area on the surface, instead of in the image.
    @param depth_adaptive If true, there are the more markers the farther away things are, as in
    @cite Weikersdorfer2012 . N is still the number asked for. Default false. It acts where there are surfaces, see
    setFocalLength(). With a mask only merging follows it, with user markers nothing does. Labels jump here and there.

    ![A room of one colour: depth as it is, surfaces, and setDepthAdaptive(true)](pics/gwatershed_surfaces.jpg) */
    CV_WRAP virtual void setDepthAdaptive(bool depth_adaptive) = 0;
    /** @brief Whether superpixels have about the same area on the surface. @see setDepthAdaptive */
    CV_WRAP virtual bool getDepthAdaptive() const = 0;

    /** @brief Sets the gradient from which GWATERSHED makes a pixel a border at the start (line 6 of Algorithm 1).

    RGWATERSHED ignores it.
    @param border_threshold A pixel with this gradient or a larger one takes no part in the flood and joins a neighbour
    after it. The gradient is the magnitude of the 3x3 Sobel derivatives, 0 to 1140, as for cv::Canny with L2gradient,
    of the grey value 0.114 B + 0.587 G + 0.299 R of the channels in this order, whatever they are: at 150, an edge of
    blue alone is none. With depth it is weighted by alpha. 0 or more, finite; 0 means no borders. Default 150: without
    them the flood crosses strong edges early, while pixels of lower priority wait, and misses half of them. */
    CV_WRAP virtual void setBorderThreshold(float border_threshold = 150.0f) = 0;
    /** @brief The gradient from which a pixel is a border, or 0 for none. @see setBorderThreshold */
    CV_WRAP virtual float getBorderThreshold() const = 0;

    //! @}
};

//! @}

} // namespace ximgproc
} // namespace cv

#endif // OPENCV_GWATERSHED_SUPERPIXEL_GWATERSHED_HPP
