/** Silhouettes of a mesh, as bounds that hold for every direction within a few degrees. */
package org.dronewatch.drone.silhouette;
