/** Where on earth a site lies: WGS 84 and the world frame. */
package org.dronewatch.geo;
