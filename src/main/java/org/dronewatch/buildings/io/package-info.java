/** Reads maps: the outlines of buildings, and what the map states about each. */
package org.dronewatch.buildings.io;
