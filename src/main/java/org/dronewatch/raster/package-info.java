/**
 * The tile rasteriser: finds what the pixels of a tile of a picture see by descending the kd-tree once for all of them and
 * rasterising the triangles on the way. A {@link org.dronewatch.raster.TileTracer} holds the scratch state of one thread.
 */
package org.dronewatch.raster;
