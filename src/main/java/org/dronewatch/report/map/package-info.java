/** Map files of a run's results: GeoJSON and KML, georeferenced by the scene's origin. */
package org.dronewatch.report.map;
