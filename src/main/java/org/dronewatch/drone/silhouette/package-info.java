/** Bounds on the silhouettes of a mesh: each belongs to a viewing direction, and holds for all directions near it. */
package org.dronewatch.drone.silhouette;
