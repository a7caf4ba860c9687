// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
package org.opencv.test.gwatershed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;

import org.opencv.core.Core;
import org.opencv.core.CvException;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.gwatershed.Gwatershed;
import org.opencv.gwatershed.SuperpixelGWatershed;
import org.opencv.imgproc.Imgproc;
import org.opencv.test.OpenCVTestCase;

// Every overload and every method of SuperpixelGWatershed from Java.
public class SuperpixelGWatershedTest extends OpenCVTestCase {

    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;

    private Mat image;
    private Mat depth;

    @Override
    protected void setUp() throws Exception {
        super.setUp();
        image = new Mat(HEIGHT, WIDTH, CvType.CV_8UC3);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                image.put(y, x, 3 * x, 4 * y, 128 + 60 * Math.sin(x / 5.0 + y / 7.0));
        depth = new Mat(HEIGHT, WIDTH, CvType.CV_16UC1, new Scalar(1500));
        depth.colRange(37, WIDTH).setTo(new Scalar(1700));
    }

    private int[] labelsOf(SuperpixelGWatershed gws) {
        Mat labels = new Mat();
        gws.getLabels(labels);
        assertEquals(CvType.CV_32SC1, labels.type());
        assertEquals(new Size(WIDTH, HEIGHT), labels.size());
        int[] values = new int[WIDTH * HEIGHT];
        labels.get(0, 0, values);
        return values;
    }

    // Checks that the labels are 0 .. N-1, each of them in use, with -1 where there is none.
    private int[] checkedLabelsOf(SuperpixelGWatershed gws, int number) {
        assertEquals(number, gws.getNumberOfSuperpixels());
        int[] labels = labelsOf(gws);
        boolean[] used = new boolean[number];
        for (int label : labels)
            if (label != -1)
                used[label] = true;
        for (boolean one : used)
            assertTrue(one);
        return labels;
    }

    private void assertSameLabels(SuperpixelGWatershed a, SuperpixelGWatershed b) {
        assertTrue(java.util.Arrays.equals(labelsOf(a), labelsOf(b)));
    }

    public void testFactoryForAnImage() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image, Gwatershed.GWATERSHED, 8, 10f);
        assertEquals(Gwatershed.GWATERSHED, gws.getAlgorithm());
        gws.iterate();
        for (int label : checkedLabelsOf(gws, 48))
            assertTrue(label >= 0);
        gws = Gwatershed.createSuperpixelGWatershed(image);
        assertEquals(Gwatershed.RGWATERSHED, gws.getAlgorithm());
        gws.iterate();
        checkedLabelsOf(gws, 30); // region size 10: five rows of six
    }

    public void testFactoryForAnImageWithDepth() {
        Mat flat = new Mat(HEIGHT, WIDTH, CvType.CV_8UC3, new Scalar(100, 100, 100));
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(
                flat, depth, Gwatershed.RGWATERSHED, 8, 10f, 0.25f);
        assertEquals(0.25f, gws.getAlpha());
        gws.iterate();
        int[] labels = checkedLabelsOf(gws, 48);
        boolean[] left = new boolean[48];
        for (int i = 0; i < labels.length; i++)
            if (i % WIDTH < 37)
                left[labels[i]] = true;
        for (int i = 0; i < labels.length; i++)
            if (i % WIDTH >= 37)
                assertFalse("a superpixel crosses the step in depth", left[labels[i]]);
    }

    public void testFactoryForASize() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(WIDTH, HEIGHT, 3, 50);
        assertTrue(gws.empty());
        try {
            gws.iterate();
            fail("there is no image yet");
        } catch (CvException expected) {
            assertTrue(expected.getMessage().contains("image"));
        }
        gws.iterate(image);
        assertFalse(gws.empty());
        checkedLabelsOf(gws, 50);
        gws.clear();
        assertTrue(gws.empty());
    }

    public void testIterate() {
        SuperpixelGWatershed a = Gwatershed.createSuperpixelGWatershed(image, depth);
        SuperpixelGWatershed b = Gwatershed.createSuperpixelGWatershed(WIDTH, HEIGHT, 3, 30);
        a.iterate(3);
        b.iterate(image, depth, 3);
        assertSameLabels(a, b);
        a.iterate();
        b.iterate(image, depth);
        assertSameLabels(a, b);
        a = Gwatershed.createSuperpixelGWatershed(image);
        a.iterate(2);
        b.iterate(image, 2);
        assertSameLabels(a, b);
    }

    public void testContourMasks() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        gws.iterate();
        Mat thick = new Mat(), thin = new Mat(), lines = new Mat(), only_thin = new Mat();
        gws.getLabelContourMask(thick);
        gws.getLabelContourMask(thin, false);
        gws.getWatershedLineMask(lines);
        assertEquals(CvType.CV_8UC1, thick.type());
        assertTrue(Core.countNonZero(thin) > 0);
        assertTrue(Core.countNonZero(thin) < Core.countNonZero(thick));
        Core.subtract(thin, thick, only_thin);
        assertEquals(0, Core.countNonZero(only_thin));
        assertEquals(0, Core.countNonZero(lines)); // RGWATERSHED makes none
    }

    public void testMask() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        Mat mask = Mat.zeros(HEIGHT, WIDTH, CvType.CV_8UC1);
        mask.submat(5, 45, 10, 50).setTo(new Scalar(1));
        gws.setMask(mask);
        gws.iterate();
        int[] labels = checkedLabelsOf(gws, 16);
        for (int i = 0; i < labels.length; i++)
            assertEquals(mask.get(i / WIDTH, i % WIDTH)[0] > 0, labels[i] >= 0);
        gws.setMask(new Mat());
        gws.iterate();
        checkedLabelsOf(gws, 30);
    }

    public void testMarkers() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        Mat markers = Mat.zeros(HEIGHT, WIDTH, CvType.CV_32SC1);
        markers.put(3, 5, 70000);
        markers.put(40, 50, 12);
        gws.setMarkers(markers);
        gws.iterate();
        int[] labels = checkedLabelsOf(gws, 2);
        assertEquals(1, labels[3 * WIDTH + 5]);
        assertEquals(0, labels[40 * WIDTH + 50]);
    }

    public void testStatistics() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        gws.iterate();
        Mat stats = new Mat(), centroids = new Mat(), colors = new Mat(), depths = new Mat();
        gws.getStatistics(image, depth, stats, centroids, colors, depths);
        int number = gws.getNumberOfSuperpixels();
        assertEquals(new Size(5, number), stats.size());
        assertEquals(new Size(2, number), centroids.size());
        assertEquals(new Size(3, number), colors.size());
        assertEquals(new Size(1, number), depths.size());
        assertEquals((double) WIDTH * HEIGHT, Core.sumElems(stats.col(Imgproc.CC_STAT_AREA)).val[0]);
        Mat mean = new Mat(); // the mean of the colours, weighed by areas, is that of the image
        Mat areas = new Mat();
        stats.col(Imgproc.CC_STAT_AREA).convertTo(areas, CvType.CV_32F);
        Core.gemm(areas, colors, 1.0 / (WIDTH * HEIGHT), new Mat(), 0, mean, Core.GEMM_1_T);
        for (int channel = 0; channel < 3; channel++)
            assertEquals(Core.mean(image).val[channel], mean.get(0, channel)[0], 0.01);
        gws.getStatistics(image, new Mat(), stats, centroids);
        assertEquals(number, stats.rows());
        Mat positions = new Mat(), normals = new Mat();
        gws.getStatistics(new Mat(), depth, stats, centroids, colors, depths, positions, normals);
        assertEquals(0, colors.rows());
        assertEquals(new Size(3, number), positions.size());
        assertEquals(new Size(3, number), normals.size());
        assertEquals(0.0, Core.norm(positions.col(2), depths, Core.NORM_INF)); // z is the mean depth
    }

    public void testAdjacency() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        gws.iterate();
        int[] labels = labelsOf(gws);
        int edges = 0;
        for (int i = 0; i < labels.length; i++) {
            if (i % WIDTH < WIDTH - 1 && labels[i] != labels[i + 1])
                edges++;
            if (i + WIDTH < labels.length && labels[i] != labels[i + WIDTH])
                edges++;
        }
        Mat pairs = new Mat(), lengths = new Mat(), contrasts = new Mat();
        gws.getAdjacency(image, new Mat(), pairs, lengths, contrasts);
        assertEquals(edges, (int) Core.sumElems(lengths).val[0]);
        assertEquals(pairs.rows(), contrasts.rows());
        for (int i = 0; i < pairs.rows(); i++)
            assertTrue(pairs.get(i, 0)[0] < pairs.get(i, 1)[0]);
    }

    public void testMerging() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        gws.iterate();
        for (int number : new int[] { 20, 5, 10 }) {
            gws.mergeSimilar(number);
            checkedLabelsOf(gws, number);
        }
        gws.enforceLabelConnectivity();
        gws.enforceLabelConnectivity(100);
        checkedLabelsOf(gws, gws.getNumberOfSuperpixels());
    }

    public void testNoDepth() {
        SuperpixelGWatershed a = Gwatershed.createSuperpixelGWatershed(image, new Mat(), Gwatershed.RGWATERSHED, 8);
        SuperpixelGWatershed b = Gwatershed.createSuperpixelGWatershed(image, Gwatershed.RGWATERSHED, 8);
        a.iterate();
        b.iterate(image, new Mat());
        assertSameLabels(a, b);
    }

    public void testSmallOnes() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        gws.iterate();
        gws.mergeSmall(500);
        assertTrue(gws.getNumberOfSuperpixels() <= WIDTH * HEIGHT / 500);
    }

    // In kB, or 0 where the system does not tell.
    private static long peakMemory() throws IOException {
        Path status = Paths.get("/proc/self/status");
        if (Files.exists(status))
            for (String line : Files.readAllLines(status))
                if (line.startsWith("VmHWM:"))
                    return Long.parseLong(line.replaceAll("\\D", ""));
        return 0;
    }

    // 500 objects that segmented 1920x1080 hold 20 GB, of which the garbage collector sees nothing: OpenCV gives these
    // tests a heap of 256 MB, and it never fills. clear() gives the memory back.
    public void testMemoryIsReleased() throws IOException {
        final int width = 1920, height = 1080, number = 576;
        Mat large = new Mat(), labels = new Mat();
        Imgproc.resize(image, large, new Size(width, height));
        for (int i = 0; i < 500; i++) {
            SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(width, height, 3, number);
            gws.iterate(large);
            assertEquals(number, gws.getNumberOfSuperpixels());
            gws.clear();
            assertTrue(gws.empty());
        }
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(large);
        gws.iterate();
        gws.getLabels(labels);
        assertEquals(new Size(width, height), labels.size());
        gws.clear();
        labels.release();
        assertTrue(labels.empty());
        large.release();
        assertTrue("memory was not given back", peakMemory() < 1 << 20);
    }

    public void testParameters() {
        SuperpixelGWatershed gws = Gwatershed.createSuperpixelGWatershed(image);
        gws.setAlgorithm(Gwatershed.GWATERSHED);
        gws.setRegionSize(9);
        assertEquals(9, gws.getRegionSize());
        gws.setDesiredSuperpixels(77);
        gws.setRuler(3.5f);
        gws.setEffort(3);
        gws.setAlpha(0.75f);
        gws.setLabInput(true);
        gws.setTemporal(true);
        gws.setValueRange(-1000, 3000);
        gws.setDepthRange(400, 4000);
        gws.setFocalLength(525, 520);
        gws.setNormalWeight(0.5f);
        gws.setDepthAdaptive(true);
        gws.setBorderThreshold(100);
        assertEquals(Gwatershed.GWATERSHED, gws.getAlgorithm());
        assertEquals(0, gws.getRegionSize());
        assertEquals(77, gws.getDesiredSuperpixels());
        assertEquals(3.5f, gws.getRuler());
        assertEquals(3, gws.getEffort());
        assertEquals(0.75f, gws.getAlpha());
        assertTrue(gws.getLabInput());
        assertTrue(gws.getTemporal());
        assertEquals(-1000f, gws.getLowValue());
        assertEquals(3000f, gws.getHighValue());
        assertEquals(400f, gws.getNearDepth());
        assertEquals(4000f, gws.getFarDepth());
        assertEquals(525f, gws.getFocalLengthX());
        assertEquals(520f, gws.getFocalLengthY());
        assertEquals(0.5f, gws.getNormalWeight());
        assertTrue(gws.getDepthAdaptive());
        assertEquals(100f, gws.getBorderThreshold());
        assertEquals("SuperpixelGWatershed", gws.getDefaultName());
        try {
            gws.setAlpha(2);
            fail("alpha is not in [0, 1]");
        } catch (CvException expected) {
            assertTrue(expected.getMessage().contains("alpha"));
        }
        assertEquals(0.75f, gws.getAlpha());
    }
}
