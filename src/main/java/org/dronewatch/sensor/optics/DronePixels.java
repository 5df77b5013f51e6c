package org.dronewatch.sensor.optics;

/**
 * The significant pixels of one drone in one frame, that is, those inside the bounding box of its projection, and which
 * of these show the drone. Immutable.
 */
public final class DronePixels {
    private final String drone;
    private final int left;
    private final int top;
    private final int columns;
    private final int rows;
    private final float[] distances;
    private final int count;

    /** The pixels of a silhouette in its present state. */
    DronePixels(String drone, Silhouette silhouette) {
        this.drone = drone;
        PixelRectangle rectangle = silhouette.rectangle();
        this.left = rectangle.left();
        this.top = rectangle.top();
        this.columns = rectangle.isEmpty() ? 0 : rectangle.right() - left + 1;
        this.rows = rectangle.isEmpty() ? 0 : rectangle.bottom() - top + 1;
        this.distances = new float[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                distances[row * columns + column] = silhouette.distance(left + column, top + row);
            }
        }
        this.count = silhouette.pixels();
    }

    /** The drone's name. */
    public String drone() {
        return drone;
    }

    /** The column of the leftmost significant pixels in the image. */
    public int left() {
        return left;
    }

    /** The row of the topmost significant pixels in the image. */
    public int top() {
        return top;
    }

    /** The number of columns that may show the drone; 0 when it is outside the image. */
    public int columns() {
        return columns;
    }

    /** The number of rows that may show the drone. */
    public int rows() {
        return rows;
    }

    /** Whether a pixel of the image shows the drone. */
    public boolean isHit(int column, int row) {
        return distance(column, row) < Float.POSITIVE_INFINITY;
    }

    /** The distance to the drone along a pixel's ray, m; infinity where the pixel does not show it. */
    public float distance(int column, int row) {
        boolean inside = column >= left && row >= top && column < left + columns && row < top + rows;
        return inside ? distances[(row - top) * columns + column - left] : Float.POSITIVE_INFINITY;
    }

    /** The number of pixels that show the drone. */
    public int count() {
        return count;
    }
}
