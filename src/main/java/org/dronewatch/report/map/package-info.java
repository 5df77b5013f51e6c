/** What a run gave as files for maps: GeoJSON and KML, from where on earth the scene's origin lies. */
package org.dronewatch.report.map;
