package org.dronewatch.report.labels;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.sensor.optics.DronePixels;

/**
 * The pixels of an image that show one drone, as COCO writes them.
 *
 * @param left column of the first hit
 * @param top row of the first hit
 * @param width columns from the first hit to the last, both included
 * @param height rows from the first hit to the last, both included
 * @param counts uncompressed run lengths, column by column from the left, each from the top: alternately of pixels
 *     without and with the drone, those without first
 */
record Mask(int left, int top, int width, int height, List<Integer> counts) {

    /**
     * The mask of a drone that has at least one hit.
     *
     * @param columns columns of the image
     * @param rows rows of the image
     */
    static Mask of(DronePixels drone, int columns, int rows) {
        List<Integer> counts = new ArrayList<>();
        int left = Integer.MAX_VALUE;
        int right = -1;
        int top = Integer.MAX_VALUE;
        int bottom = -1;
        int runStart = 0;
        boolean within = false;
        for (int column = drone.left(); column < drone.left() + drone.columns(); column++) {
            for (int row = drone.top(); row < drone.top() + drone.rows(); row++) {
                boolean hit = drone.isHit(column, row);
                int at = column * rows + row;
                if (hit) {
                    left = Math.min(left, column);
                    right = column;
                    top = Math.min(top, row);
                    bottom = Math.max(bottom, row);
                }
                if (hit != within) {
                    counts.add(at - runStart);
                    runStart = at;
                    within = hit;
                }
            }
            int below = column * rows + drone.top() + drone.rows();
            // In a rectangle as high as the image, a run may continue at the top of the next column.
            if (within && drone.rows() < rows) {
                counts.add(below - runStart);
                runStart = below;
                within = false;
            }
        }
        counts.add(columns * rows - runStart);
        if (within) {
            // The rectangle is as high as the image: after the last column, the rest has no hit.
            int end = (drone.left() + drone.columns()) * rows;
            counts.set(counts.size() - 1, end - runStart);
            counts.add(columns * rows - end);
        }
        if (counts.get(counts.size() - 1) == 0) {
            counts.remove(counts.size() - 1);
        }
        return new Mask(left, top, right - left + 1, bottom - top + 1, List.copyOf(counts));
    }
}
