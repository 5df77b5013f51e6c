/** What a run gave as files for maps: GeoJSON and KML, from the place on earth of the scene's origin. */
package org.dronewatch.report.map;
