/** Measurement between two points of the site: distances, bearing and line of sight. */
package org.dronewatch.viewer.tape;
