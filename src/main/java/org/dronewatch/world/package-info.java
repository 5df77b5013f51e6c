/** The site and what flies in it: models read from files, the world's tree, drones and their flight paths. */
package org.dronewatch.world;
