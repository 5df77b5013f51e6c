/** Silhouettes of a mesh, as bounds, each of which holds for all directions within a few degrees of its own. */
package org.dronewatch.drone.silhouette;
