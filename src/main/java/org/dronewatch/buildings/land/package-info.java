/** Land cover according to the map (water, roads, woods, ...), drawn into a raster. */
package org.dronewatch.buildings.land;
