/** The ground of a real place: files of elevations become triangles in the world frame. */
package org.dronewatch.terrain;
