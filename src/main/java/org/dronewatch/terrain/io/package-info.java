/** Reads files of elevations: where their posts are on the map, and how high. */
package org.dronewatch.terrain.io;
