package org.dronewatch.buildings.land;

/**
 * The land cover that a shape on a map represents.
 *
 * @param land its class
 * @param layer the layer, which decides what is drawn over what
 * @param width width of a line, m; 0 for an area
 */
record LandUse(LandClass land, Layer layer, double width) {
    /** Kinds of shapes in the order in which they are drawn; within one, larger areas come first. */
    enum Layer {
        AREA,
        WATERWAY,
        WATER,
        PAVED,
        RAILWAY,
        PATH,
        ROAD
    }

    static LandUse area(LandClass land, Layer layer) {
        return new LandUse(land, layer, 0.0);
    }

    boolean isArea() {
        return width == 0.0;
    }
}
