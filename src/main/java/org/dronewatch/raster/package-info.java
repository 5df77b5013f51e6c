/**
 * The tile rasteriser: finds the nearest triangle for each pixel of a tile of an image by descending the kd-tree once
 * for all of them and rasterising the triangles on its path. A {@link org.dronewatch.raster.TileTracer} holds the
 * scratch state of one thread.
 */
package org.dronewatch.raster;
