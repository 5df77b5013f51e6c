/** The ground of a real place: elevation files are converted to triangles in the world frame. */
package org.dronewatch.terrain;
