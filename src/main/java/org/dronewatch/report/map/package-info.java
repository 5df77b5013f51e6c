/** Map files of results: GeoJSON, KML and GeoTIFF, georeferenced by the scene's origin. */
package org.dronewatch.report.map;
