/** What covers the ground according to the map (water, roads, woods, ...), drawn into a raster. */
package org.dronewatch.buildings.land;
