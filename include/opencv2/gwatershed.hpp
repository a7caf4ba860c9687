// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_HPP
#define OPENCV_GWATERSHED_HPP

#include "opencv2/core.hpp"

#include <type_traits>

/**
@defgroup gwatershed Superpixels by a marker-controlled watershed on a gradient map

The module holds one class, cv::ximgproc::SuperpixelGWatershed, which divides a colour image, or a
colour image with its depth map, into superpixels after @cite Jiang2015. Its interface follows
SuperpixelSLIC and SuperpixelSEEDS of the module ximgproc, which it does not need. @ref tutorial_gwatershed
begins with code for SuperpixelSLIC.
*/

namespace cv
{
namespace ximgproc
{

//! @addtogroup gwatershed
//! @{

//! Algorithms of SuperpixelGWatershed.
enum GWatershedType
{
    //! Algorithm 1 of @cite Jiang2015 : the priority of a pixel is its distance to the neighbour that
    //! reaches it. One pass; `ruler` and `num_iterations` have no effect.
    GWATERSHED = 200,
    //! Region-guided: the priority of a pixel is its distance to the mean of the region that reaches
    //! it. The default, and better in every measure of quality.
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

**RGWATERSHED**, the default, is the method to use. It has these steps:
1. Features: lightness and two colour differences of each pixel, and its depth; their means over
   blocks of 2x2 or 4x4 pixels where superpixels are large enough.
2. Markers: four for each superpixel asked for, one in each cell of a grid of blocks, away from
   high gradients.
3. A flood of the blocks through first-in first-out queues, one for each priority. The priority of a
   block is its distance to the mean of the region that reaches it, plus its distance to the marker.
4. Similar neighbours are merged until as many regions are left as superpixels are asked for, in rounds: of the pairs of
   regions that are the most similar neighbours of each other, the more similar ones are merged at once.
5. The boundary is settled from blocks down to pixels: its pixels go to the neighbouring region
   that is nearest in colour and depth and leaves the shortest boundary. Each further iteration
   does more of that.

**GWATERSHED** is Algorithm 1 of the paper, kept exactly for comparison: gradient map, one marker
for each superpixel at a low gradient, and a flood where the priority of a pixel is its distance to the
neighbour that reaches it, equations (1) to (4). The watershed lines, where two floods meet, go
to the most similar neighbour at the end.

**Result.** Every pixel has a label, every label of [0, N) occurs, and the pixels of one label are
one 4-connected component. Labels are in the order of the
cells of the grid of markers. The result depends on the image, the depth and the parameters only: it is
the same for any number of threads, in every run, and for a submatrix and its clone. setMask(),
setMarkers() and setTemporal() say what else is possible: pixels without a label, which are -1, markers
of the user, and labels that stay from frame to frame.

**Images.** 8-bit, 16-bit unsigned or 32-bit float, with 1, 3 or 4 channels (the fourth, alpha, is
ignored), as Mat or UMat. White is 255, 65535 or 1.0, and so is what is larger; NaN is black. The image is
brought to 8 bits; stretch one that uses a small part of its range beforehand. Three channels are BGR, and
RGWATERSHED converts them itself: give it images as imread() or a camera does, or see setLabInput(). GWATERSHED
compares the channels as they are. The pixels, with a frame of one around the image, must be fewer
than 2^31 - 3.

**Depth.** CV_16UC1 (sensor units, usually millimetres; 0 is missing), CV_32FC1 (usually metres;
NaN, infinity, 0 and below are missing) or CV_8UC1 (already scaled; 0 is missing), of the size of
the image. Where depth is missing, colour alone counts. Depth that is missing or equal everywhere
changes nothing. See setDepthRange() and setAlpha(). For depth alone set alpha to 0, or give the
depth as a gray image.

**Errors.** A wrong argument throws cv::Exception, which names it, before anything is changed, and the object stays
usable. So it does where memory runs out, which throws cv::Exception with Error::StsNoMem; after that in iterate()
there is no segmentation, and empty() is true. The images given are never written to. In Python, None for a number
is its default: check what imread() returned, since `iterate(None)` is `iterate()`, and `iterate(image, None)` is
`iterate(image)`.

**Outputs** are a Mat or UMat, allocated as needed, whatever they were before, or a Mat_ of the type given; what has one
row or column may also be a std::vector of that type.

**Threads.** Most loops over pixels, the flood of RGWATERSHED and the moves of boundary pixels run under
cv::parallel_for_, and so does most of merging; the flood of GWATERSHED, and that of RGWATERSHED with a mask,
markers of the user or for
the parts of a frame that are new run on the calling thread. Different objects can be
used in different threads at the same time; one object can not, except for its const methods.

**Algorithm.** write() and read() store and restore the parameters; read() throws and changes
nothing if one is missing or out of its range. clear() drops the segmentation, the image of the
factory, the mask, the markers and the buffers; the parameters stay. empty() tells whether there is no
segmentation.

**Cost.** Time and memory are linear in the number of pixels; merging adds about two microseconds for each
superpixel, most of the time where superpixels are smaller than about 10x10 pixels. Buffers of the
size of the image, and those of the regions, stay from one image to the next; a mask, and markers of the user, need
some more for the time of a call.
*/
class CV_EXPORTS_W SuperpixelGWatershed : public Algorithm
{
public:
    /** @brief Number of superpixels N of the current segmentation, 0 before the first iterate().

    N is the number of superpixels asked for, or the number of pixels where that is smaller, until
    enforceLabelConnectivity() or mergeSimilar() merges some. See also setMask() and setMarkers().
    */
    CV_WRAP virtual int getNumberOfSuperpixels() const = 0;

    /** @brief Segments the image, and depth, that were given to the factory.

    The image is the copy made by the factory; iterate() of another image does not replace it.
    Each call starts anew with the current parameters, unless setTemporal() says otherwise.

    @param num_iterations 1 or more. For RGWATERSHED, each iteration after the first moves boundary
    pixels where that explains the colours of the image better, so explained variation, of the image at 8 bits,
    never falls; its work is proportional to the boundary that still moves, and ends where none does. From the
    17th on, depth alone moves no pixel. GWATERSHED is one pass: more than 1 changes nothing.

    ![After 1, 2, 4 and 8 iterations](pics/gwatershed_iterations.jpg)

    Throws cv::Exception if the factory was given a size instead of an image, and after clear().
    */
    CV_WRAP virtual void iterate(int num_iterations = 1) = 0;

    /** @overload
    @brief Segments another image, of any size and of any type named above.
    @param image Image to segment. It is not kept.
    @param num_iterations See above.
    */
    CV_WRAP virtual void iterate(InputArray image, int num_iterations = 1) = 0;

    /** @overload
    @brief Segments another image with its depth.
    @param image Image to segment. It is not kept.
    @param depth CV_16UC1, CV_32FC1 or CV_8UC1 depth map of the size of the image. It is not kept.
    @param num_iterations See above.
    */
    CV_WRAP virtual void iterate(InputArray image, InputArray depth, int num_iterations = 1) = 0;

    /** @brief Returns a copy of the label map.

    @param labels_out CV_32SC1 map of the size of the image; values in [0, N), -1 outside of a mask and where
    no marker of the user reaches.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getLabels(OutputArray labels_out) const = 0;

    /** @brief Returns the contours of the superpixels as a mask.

    @param image CV_8UC1 mask of the size of the image: 255 on contours, 0 elsewhere.
    @param thick_line If true, a pixel is on a contour when any of its 4 neighbours has another
    label: lines of two pixels. If false, when its right or lower neighbour has: lines of one
    pixel, part of the thick ones. Either way every pair of neighbours with different labels has
    a contour pixel. Beside pixels without a label there is no contour, as at the border of the image.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getLabelContourMask(OutputArray image, bool thick_line = true) const = 0;

    /** @brief Returns the watershed lines of Algorithm 1, before they were given to the superpixels.

    @param image CV_8UC1 mask of the size of the image: 255 where two floods met, where the
    gradient reached the border threshold, and where no flood came because of it; 0 elsewhere, and
    everywhere after RGWATERSHED, which makes no lines.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getWatershedLineMask(OutputArray image) const = 0;

    /** @brief Merges superpixels that are too small into a neighbour.

    Superpixels are connected without this call. The smallest goes first, into the neighbour with
    which it has the longest common boundary. Labels are numbered anew without gaps, in the old
    order; N falls.

    @param min_element_size Smallest area allowed, in percent of the mean area (number of pixels with a
    label over N), in [0, 100]. 0 merges nothing. A superpixel without a neighbour stays as it is.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void enforceLabelConnectivity(int min_element_size = 25) = 0;

    //! @name What comes after the segmentation
    //! @{

    /** @brief Merges neighbouring superpixels, the most similar first, until a number is left.

    @code{.cpp}
        gws->iterate(image);         // 1600 superpixels
        gws->mergeSimilar(400);
        gws->getLabels(coarse);
        gws->mergeSimilar(800);      // back to a finer level of the same hierarchy
    @endcode

    The first call after iterate(), or after enforceLabelConnectivity() has merged some, finds the order in
    which all superpixels are merged; every call takes the first steps of it. So the partitions for all numbers
    are nested, whatever the order of the calls, and a call after the first costs little more than
    writing the labels. Superpixels stay connected. Labels are numbered anew without gaps, in the
    old order.

    The order is found in rounds. In each of them, pairs of superpixels that are the best neighbours of each other, at
    the lowest cost for both, are candidates; the cheaper 40 % of the candidates are merged, cheapest first. A superpixel
    of more than 64 neighbours takes in several at once, each of which has its lowest cost there. So what is merged
    was the best choice for both when the round began, but a pair of a later round can be cheaper than one of a round
    before. The cost is Ward's criterion, as stepwise optimization @cite Beaulieu1989 uses it, with changes found by
    measurement:
    @f[ (d^2 + 4)\left(\frac{n_a n_b}{n_a + n_b}\right)^{1.75}
        (h + 1)^{1/2} \left(l / \sqrt{\min(n_a, n_b)}\right)^{-1} @f]
    d is the distance of the mean colours and depths, n the number of pixels, l the length of the common
    boundary in pixel edges and h the mean difference of the pixels on both sides of it. d, a root of a sum of
    squares, and h, a sum, are in 8-bit levels of the opponent space in which RGWATERSHED works, with lightness
    halved, or of the colours as they are after setLabInput(true); alpha weighs depth as it does there. It is
    computed with logarithms in steps of 1/256 of a doubling, straight between powers of two.

    @param num_superpixels Number to reach, 1 or more. Where more are left because the rest do not touch,
    across the outside of a mask, N is larger; where there are fewer to begin with, nothing is merged.

    Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void mergeSimilar(int num_superpixels) = 0;

    /** @brief Measures all superpixels in one pass: area, bounding box, centroid, mean colour, mean depth.

    @code{.cpp}
        gws->getStatistics(image, noArray(), stats, centroids, mean_colors);
    @endcode

    @param image Image of the size of the label map, of any depth and number of channels: the one that was
    segmented, or another one, as optical flow or normals. Empty (noArray(), None in Python): no mean colours.
    @param depth CV_8UC1, CV_16UC1 or CV_32FC1 depth map of the same size. Empty: no mean depths.
    @param stats N x 5 CV_32SC1, a row for each superpixel, columns as of connectedComponentsWithStats():
    CC_STAT_LEFT, CC_STAT_TOP, CC_STAT_WIDTH, CC_STAT_HEIGHT, CC_STAT_AREA, in pixels.
    @param centroids N x 2 CV_64FC1, x and y.
    @param mean_colors N x C CV_32FC1, a column for each channel, in the unit of image.
    @param mean_depths N x 1 CV_32FC1, in the unit of depth, over the pixels where it is valid: larger than 0 and
    finite. NaN where there is none.

    A table without rows is None in Python. Throws cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getStatistics(InputArray image, InputArray depth, OutputArray stats, OutputArray centroids,
                                       OutputArray mean_colors = noArray(),
                                       OutputArray mean_depths = noArray()) const = 0;

    /** @brief Lists the superpixels that touch: the region adjacency graph.

    @param image Image of the size of the label map, of a type that iterate() takes, for the contrasts: the one that
    was segmented, or another one. Empty (noArray(), None in Python): no contrasts.
    @param depth Depth of that image, with the range and alpha of the last iterate(). Empty: colour alone. It must be
    empty where image is.
    @param pairs M x 2 CV_32SC1: labels a < b of two superpixels with a common boundary, in rows
    sorted by a, then b. Pixels touch if they are 4-neighbours.
    @param lengths M x 1 CV_32SC1, length of the boundary in pixel edges.
    @param contrasts M x 1 CV_32FC1, contrast of the boundary: the mean of the distance of the pixels on both
    sides of its edges, equations (1) to (3) of the paper, 0..255.

    Without a mask or markers of the user the graph is connected. A table without rows is None in Python. Throws
    cv::Exception before the first iterate().
    */
    CV_WRAP virtual void getAdjacency(InputArray image, InputArray depth, OutputArray pairs, OutputArray lengths,
                                      OutputArray contrasts = noArray()) const = 0;

    //! @}

    //! @name What to segment. It takes effect at the next iterate().
    //! @{

    /** @brief Restricts the segmentation to a part of the images to come.

    Outside pixels have the label -1 and are 0 in the masks of contours and lines; what they look like changes
    nothing inside. The number of superpixels and the region size count pixels inside only. Every connected
    component of the mask has at least one superpixel: N is the number asked for or, if that is larger, the
    number of components. Labels are in the order of the components then, specks last. A mask that is zero
    everywhere gives N = 0.

    @param mask CV_8UC1, non-zero inside (in Python, `inside.astype(np.uint8)` of a boolean array); iterate()
    throws if it has not the size of the image. It is copied, and stays until it is replaced, or dropped by an
    empty one or by clear().
    */
    CV_WRAP virtual void setMask(InputArray mask) = 0;

    /** @brief Sets the markers that superpixels grow from, as for cv::watershed.

    N is the number of different positive values inside of the mask, and labels are in the order of the values; the
    number of superpixels and the region size do not count. Markers keep all of their pixels. They may touch each
    other and the border of the image; of a marker in several pieces, the superpixel has as many at most. Pixels
    that no marker reaches, in other components of a mask, have the label -1, and all of them if there
    is no marker. RGWATERSHED floods pixels then, not blocks of them, which takes longer, and the ruler acts where
    boundaries are settled, not in the flood.

    @param markers CV_32SC1: positive values are markers, others unknown, so a label map of getLabels() needs 1
    added; iterate() throws if it has not the size of the image. It is copied, and stays until it is replaced, or
    dropped by an empty one or by clear().
    */
    CV_WRAP virtual void setMarkers(InputArray markers) = 0;

    //! @}

    //! @name Parameters. They take effect at the next iterate().
    //! @{

    /** @brief Sets the algorithm.
    @param algorithm One of #GWatershedType. */
    CV_WRAP virtual void setAlgorithm(int algorithm) = 0;
    /** @brief The algorithm, one of #GWatershedType. @see setAlgorithm */
    CV_WRAP virtual int getAlgorithm() const = 0;

    /** @brief Asks for superpixels of a mean size; replaces what setDesiredSuperpixels() asked for.
    @param region_size Side in pixels of the square that a superpixel fills on the mean, 1 or more:
    N is the integer nearest to W * H / region_size^2, at least 1. */
    CV_WRAP virtual void setRegionSize(int region_size) = 0;
    /** @brief Region size in pixels, or 0 where a number of superpixels is asked for. @see setRegionSize */
    CV_WRAP virtual int getRegionSize() const = 0;

    /** @brief Asks for a number of superpixels; replaces what setRegionSize() asked for.
    @param num_superpixels Number of superpixels, 1 or more. It is met exactly; an image with fewer
    pixels gets one superpixel for each pixel. */
    CV_WRAP virtual void setDesiredSuperpixels(int num_superpixels) = 0;
    /** @brief Number asked for, or 0 where a region size is asked for. @see setDesiredSuperpixels */
    CV_WRAP virtual int getDesiredSuperpixels() const = 0;

    /** @brief Sets the compactness.
    @param ruler 0 or more, finite. Default 10, the best all-round setting. 0 follows the image alone,
    with frayed boundaries; small values give high boundary recall, larger ones more compact
    superpixels, in proportion up to about 50. It does not depend on the bit depth of the image
    or on the size of superpixels. GWATERSHED has no such term: it stores the value and does not use it.

    ![ruler from 0 to 40](pics/gwatershed_ruler.jpg) */
    CV_WRAP virtual void setRuler(float ruler) = 0;
    /** @brief The compactness. @see setRuler */
    CV_WRAP virtual float getRuler() const = 0;

    /** @brief Sets the weight of colour against depth, equation (3) of the paper.
    @param alpha In [0, 1]: Dist = alpha * Dist_RGB + (1 - alpha) * Dist_D, in steps of 1/256. 1 is
    colour alone, 0 is depth alone where there is depth, but for iterations after the first, which move no
    pixel to a colour that is farther. Default 0.5, as in the paper; less where
    colour misleads. Without depth it has no effect. RGWATERSHED divides the distance by the larger of
    the two weights, so that pixels with and without depth compare.

    ![alpha from 1, colour alone, to 0, depth alone](pics/gwatershed_alpha.jpg) */
    CV_WRAP virtual void setAlpha(float alpha) = 0;
    /** @brief The weight of colour against depth. @see setAlpha */
    CV_WRAP virtual float getAlpha() const = 0;

    /** @brief Tells whether images come in a perceptually uniform colour space.
    @param uniform If false, the default, images are BGR and RGWATERSHED converts them to an
    opponent space. If true, it takes the channels as they are: lightness and two colour
    differences, for example CIELAB as cv::cvtColor makes it. GWATERSHED never converts. */
    CV_WRAP virtual void setLabInput(bool uniform) = 0;
    /** @brief Whether images come in a perceptually uniform colour space. @see setLabInput */
    CV_WRAP virtual bool getLabInput() const = 0;

    /** @brief Sets whether superpixels keep their labels from frame to frame.
    @param temporal If true, each iterate() of an image goes on from the segmentation of the last one: a
    superpixel has the same label as long as it can be followed, over motions of a few pixels
    from frame to frame. For RGWATERSHED, the boundaries move to where things are now; superpixels that
    explain the image much worse than when they were made are made anew, as many as before, and their
    labels go to new ones, so N stays what it was. If half of the image has changed, all start anew. For
    GWATERSHED, each marker moves to the middle of its last region; those of regions that have all but vanished
    move into the largest ones. On a still image boundaries go on moving a little, too. A frame of another size,
    mask, number of superpixels or algorithm, one with markers of the user and the first one after clear() start
    anew, and for RGWATERSHED one with a ruler so different that other blocks are flooded. If false, the default,
    each frame is segmented by itself.
    @note Merging, by mergeSimilar() or enforceLabelConnectivity(), numbers labels anew for one frame; the next
    frame goes on from what iterate() gave. */
    CV_WRAP virtual void setTemporal(bool temporal) = 0;
    /** @brief Whether superpixels keep their labels from frame to frame. @see setTemporal */
    CV_WRAP virtual bool getTemporal() const = 0;

    /** @brief Sets the range of depth that is scaled to the 1..255 of equation (2).

    A range makes the scale the same for every frame. CV_8UC1 depth is taken as it is.

    @param near_depth Depth, in the unit of the depth map, that becomes 1; what is nearer, too.
    @param far_depth Depth that becomes 255; what is farther, too. 0 <= near_depth < far_depth, or
    both 0, the default: the range from the 1st to the 99th percentile of the valid depth of the
    frame, taken over a regular sample of it, or from its minimum to its maximum if these are equal. */
    CV_WRAP virtual void setDepthRange(float near_depth, float far_depth) = 0;
    /** @brief The depth that becomes 1, or 0 where the range is taken from the frame. @see setDepthRange */
    CV_WRAP virtual float getNearDepth() const = 0;
    /** @brief The depth that becomes 255, or 0 where the range is taken from the frame. @see setDepthRange */
    CV_WRAP virtual float getFarDepth() const = 0;

    /** @brief Sets the gradient from which a pixel is a border at the start (line 6 of Algorithm 1).

    For GWATERSHED; RGWATERSHED does not use it.
    @param border_threshold A pixel whose gradient is equal or larger takes no part in the flood
    and joins a neighbour after it. The gradient is the magnitude of the 3x3 Sobel derivatives of
    8-bit values, 0..1443, as for the thresholds of cv::Canny with L2gradient; for RGB-D it is
    weighted by alpha as the distance is. 0 means none. Default 150: without borders the flood
    crosses strong edges before it has come back to the low heights, and follows half of them. */
    CV_WRAP virtual void setBorderThreshold(float border_threshold) = 0;
    /** @brief The gradient from which a pixel is a border, or 0 for none. @see setBorderThreshold */
    CV_WRAP virtual float getBorderThreshold() const = 0;

    //! @}
};

/** @brief Makes an object for images of a given size, as createSuperpixelSEEDS() does.

@param image_width Width in pixels of the images to come, 1 or more; buffers are allocated for it.
Images of another size are taken as well.
@param image_height Height in pixels, 1 or more.
@param image_channels 1, 3 or 4; images with another number of these are taken as well.
@param num_superpixels Number of superpixels, met exactly. See SuperpixelGWatershed::setDesiredSuperpixels.
@param algorithm One of #GWatershedType.
@param ruler Compactness. See SuperpixelGWatershed::setRuler.
*/
CV_EXPORTS_W Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        int image_width, int image_height, int image_channels, int num_superpixels,
        int algorithm = RGWATERSHED, float ruler = 10.0f);

/** @overload
@brief Makes an object for an image, as createSuperpixelSLIC() does.

@param image Image to segment; a copy is kept for SuperpixelGWatershed::iterate(int).
@param algorithm One of #GWatershedType.
@param region_size Side in pixels of a superpixel. See SuperpixelGWatershed::setRegionSize.
@param ruler Compactness. See SuperpixelGWatershed::setRuler.
*/
CV_EXPORTS_W Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        InputArray image, int algorithm = RGWATERSHED, int region_size = 10, float ruler = 10.0f);

//! For a ruler of another type, such as 10: it is a float.
template <typename Ruler>
inline typename std::enable_if<std::is_arithmetic<Ruler>::value, Ptr<SuperpixelGWatershed> >::type
createSuperpixelGWatershed(InputArray image, int algorithm, int region_size, Ruler ruler)
{
    return createSuperpixelGWatershed(image, algorithm, region_size, static_cast<float>(ruler));
}

/** @overload
@brief Makes an object for an image with depth.

@param image Image to segment; a copy is kept for SuperpixelGWatershed::iterate(int).
@param depth CV_16UC1, CV_32FC1 or CV_8UC1 depth map of the size of the image; a copy is kept.
@param algorithm One of #GWatershedType.
@param region_size Side in pixels of a superpixel. See SuperpixelGWatershed::setRegionSize.
@param ruler Compactness. See SuperpixelGWatershed::setRuler.
@param alpha Weight of colour against depth. See SuperpixelGWatershed::setAlpha.
*/
CV_EXPORTS_W Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        InputArray image, InputArray depth, int algorithm = RGWATERSHED, int region_size = 10,
        float ruler = 10.0f, float alpha = 0.5f);

//! @}

} // namespace ximgproc
} // namespace cv

#endif // OPENCV_GWATERSHED_HPP
