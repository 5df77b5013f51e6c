/** Readers of elevation files: positions and heights of their posts. */
package org.dronewatch.terrain.io;
