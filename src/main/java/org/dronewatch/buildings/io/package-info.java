/** Readers of maps: the outlines of buildings, and their attributes. */
package org.dronewatch.buildings.io;
