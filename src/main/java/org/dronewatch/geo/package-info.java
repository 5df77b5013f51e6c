/** Geographic coordinates of a site: WGS 84, the world frame, and the coordinates of maps. */
package org.dronewatch.geo;
