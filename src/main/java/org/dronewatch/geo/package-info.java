/** Where on earth a site lies: WGS 84, the world frame, and the coordinates of maps. */
package org.dronewatch.geo;
